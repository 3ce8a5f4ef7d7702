#pragma once

#include <cstdint>

namespace bslnav {

/** What a cell of a cost map says, as in the paper and in ROS: 1 to 252 is graded, higher costs
 * more. */
using Cost = std::uint8_t;

inline constexpr Cost kFreeCost = 0;
inline constexpr Cost kHighestGradedCost = 252;  ///< also the cap of the blind spot cost
inline constexpr Cost kInscribedCost =
    253;                                   ///< a robot centred here touches an obstacle for certain
inline constexpr Cost kLethalCost = 254;   ///< an obstacle is in this cell
inline constexpr Cost kUnknownCost = 255;  ///< nothing is known; not the same as free

}  // namespace bslnav
