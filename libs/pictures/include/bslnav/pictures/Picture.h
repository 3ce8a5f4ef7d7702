#pragma once

#include <bslnav/pictures/ColourMap.h>

#include <cstddef>
#include <string>
#include <vector>

namespace bslnav {

/** A finished picture: rows from the top, 8 bits a channel in the order red, green, blue. */
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  /** The colour at column x from the left and row y from the top; both inside the picture. */
  Colour pixel(int x, int y) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }

  /** Writes a PNG; identical pictures give identical files. @throws Error (Run) when it cannot. */
  void save(const std::string& path) const;
};

}  // namespace bslnav
