#include <bslnav/pictures/ColourMap.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bslnav {
namespace {

using Anchors = std::array<Colour, 8>;  // equally spaced from 0 to 1

constexpr Anchors kSpeed{{{68, 1, 84},
                          {71, 45, 123},
                          {59, 82, 139},
                          {44, 114, 142},
                          {33, 145, 140},
                          {40, 174, 128},
                          {94, 201, 98},
                          {160, 218, 57}}};
constexpr Anchors kCellCost{{{255, 250, 219},
                             {255, 237, 160},
                             {254, 217, 118},
                             {254, 178, 76},
                             {253, 141, 60},
                             {248, 84, 44},
                             {224, 32, 30},
                             {168, 4, 36}}};
constexpr Anchors kTotalCost{{{8, 48, 107},
                              {14, 72, 142},
                              {28, 98, 172},
                              {46, 126, 188},
                              {72, 153, 200},
                              {100, 178, 208},
                              {132, 198, 214},
                              {160, 214, 220}}};

const Anchors& anchorsOf(ColourMap map) {
  if (map == ColourMap::Speed) return kSpeed;
  return map == ColourMap::CellCost ? kCellCost : kTotalCost;
}

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, double fraction) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * fraction));
}

}  // namespace

Colour mixed(Colour a, Colour b, double fraction) {
  return {mixed(a.r, b.r, fraction), mixed(a.g, b.g, fraction), mixed(a.b, b.b, fraction)};
}

Colour colourAt(ColourMap map, double fraction) {
  const Anchors& anchors = anchorsOf(map);
  const double clamped = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0;  // NaN gives 0
  const double position = clamped * static_cast<double>(anchors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), anchors.size() - 2);
  return mixed(anchors[below], anchors[below + 1], position - static_cast<double>(below));
}

}  // namespace bslnav
