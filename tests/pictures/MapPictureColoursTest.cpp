#include <bslnav/pictures/ColourMap.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace bslnav {
namespace {

/** Relative luminance of an sRGB colour, 0 to 1 (IEC 61966-2-1). */
double luminance(Colour c) {
  const auto linear = [](std::uint8_t v) {
    const double s = v / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

RC_GTEST_PROP(ColourMap, LightnessKeepsTheOrderOfValues, ()) {
  const int a = *rc::gen::inRange(0, 1000), b = *rc::gen::inRange(a + 20, 1021);
  const double low = a / 1020.0, high = b / 1020.0;
  RC_ASSERT(luminance(colourAt(ColourMap::Speed, low)) <
            luminance(colourAt(ColourMap::Speed, high)));
  RC_ASSERT(luminance(colourAt(ColourMap::CellCost, low)) >
            luminance(colourAt(ColourMap::CellCost, high)));
  RC_ASSERT(luminance(colourAt(ColourMap::TotalCost, low)) <
            luminance(colourAt(ColourMap::TotalCost, high)));
}

TEST(ColourMap, ClampsAndTakesNanForTheLowest) {
  const Colour lowest = colourAt(ColourMap::Speed, 0.0), highest = colourAt(ColourMap::Speed, 1.0);
  EXPECT_NE(lowest, highest);
  EXPECT_EQ(colourAt(ColourMap::Speed, -3.0), lowest);
  EXPECT_EQ(colourAt(ColourMap::Speed, 7.0), highest);
  EXPECT_EQ(colourAt(ColourMap::Speed, std::numeric_limits<double>::quiet_NaN()), lowest);
}

TEST(ColourMap, MixesChannelByChannel) {
  EXPECT_EQ(mixed({0, 100, 200}, {100, 0, 200}, 0.25), (Colour{25, 75, 200}));
}

}  // namespace
}  // namespace bslnav
