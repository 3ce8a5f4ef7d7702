#include <bslnav/navigation/CycleRecord.h>

namespace bslnav {

const char* nameOf(CycleRecord::Health health) {
  static constexpr const char* kNames[] = {"ok", "stale_sensor", "no_beams", "bad_pose"};
  return kNames[static_cast<int>(health)];
}

std::string reasonOf(const CycleRecord& record) {
  switch (record.health) {
    case CycleRecord::Health::NoBeams:
      return "no usable beam in the scan";
    case CycleRecord::Health::StaleSensor:
      return record.sensorProblem;
    case CycleRecord::Health::BadPose:
      return "the pose is not a number";
    case CycleRecord::Health::Ok:
      break;
  }
  if (record.motion.mode == MotionMode::Arrived) return "";
  if (record.pathStatus != PathResult::Status::Found) return describe(record.pathStatus);
  if (record.motion.blocked) return "no admissible velocity";
  return record.motion.mode == MotionMode::Failed ? "no progress" : "";
}

}  // namespace bslnav
