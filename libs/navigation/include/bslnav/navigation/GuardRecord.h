#pragma once

#include <bslnav/blindspot/Frontier.h>

#include <cstdint>
#include <optional>

namespace bslnav {

/** The guard's certificate of a cycle: from the command that was sent, the robot stands before
 * anybody can reach it, by so much; or why that is not so. */
struct GuardRecord {
  enum class Lapse : std::uint8_t {
    None,
    Creeping,   ///< nothing was admissible for a while: the robot creeps
    Surprised,  ///< somebody may be nearer than the cycle before foresaw: the robot brakes
    Blind       ///< nothing was seen in this cycle: the robot brakes
  };
  bool active = false;
  bool capped = false;         ///< the command was not admissible, and was slowed down
  double bound_mps = 0.0;      ///< highest admissible speed along the command's arc
  double slack_m = 0.0;        ///< least distance that is left; negative when the promise lapsed
  double reachAtStop_m = 0.0;  ///< how far people may have walked when the robot stands
  double impact_mps = 0.0;     ///< worst case: the robot's speed when somebody reaches it
  std::optional<FrontierPoint> binding;  ///< what decides, map frame
  int hidden = 0, seen = 0;              ///< frontier points
  Lapse lapse = Lapse::None;
};

/** The word for a lapse in records and tables. */
const char* nameOf(GuardRecord::Lapse lapse);

}  // namespace bslnav
