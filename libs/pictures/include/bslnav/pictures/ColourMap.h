#pragma once

#include <cstdint>

namespace bslnav {

/** An sRGB colour. */
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;

  bool operator==(const Colour& o) const { return r == o.r && g == o.g && b == o.b; }
  bool operator!=(const Colour& o) const { return !(*this == o); }
};

/** Colour maps of steadily rising or falling lightness: they keep their order in grey print. */
enum class ColourMap {
  Speed,     ///< slow is dark violet, fast is light green (viridis without its yellow end)
  CellCost,  ///< cheap is pale yellow, expensive is dark red
  TotalCost  ///< the best (lowest) is dark blue, the worst is pale cyan
};

/** The colour at 0 (lowest) to 1 (highest); clamped outside, NaN counts as 0. */
Colour colourAt(ColourMap map, double fraction);

/** The colour between two others, channel by channel: `a` at 0, `b` at 1. */
Colour mixed(Colour a, Colour b, double fraction);

}  // namespace bslnav
