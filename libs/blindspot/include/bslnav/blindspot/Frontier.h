#pragma once

#include <cstdint>
#include <vector>

namespace bslnav {

/** A place, in the map frame, from which somebody may step in the robot's way. */
struct FrontierPoint {
  enum class Kind : std::uint8_t {
    Hidden,   ///< the edge of a place where somebody may be whom no sensor sees
    Seen,     ///< somebody who is seen, and may walk off
    Standing  ///< somebody who has been seen standing for a while
  };
  float x_m = 0.0f, y_m = 0.0f;
  Kind kind = Kind::Hidden;
};
using Frontier = std::vector<FrontierPoint>;

/** The word for a kind in records and tables. */
inline const char* nameOf(FrontierPoint::Kind kind) {
  constexpr const char* kNames[] = {"hidden", "seen", "standing"};
  return kNames[static_cast<int>(kind)];
}

}  // namespace bslnav
