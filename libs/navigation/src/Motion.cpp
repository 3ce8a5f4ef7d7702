#include <bslnav/navigation/Motion.h>

namespace bslnav {

const char* nameOf(MotionMode mode) {
  static constexpr const char* kNames[] = {"idle",         "follow",         "rotate_to_path",
                                           "stop_at_goal", "rotate_to_goal", "back_off",
                                           "make_way",     "arrived",        "failed"};
  return kNames[static_cast<int>(mode)];
}

}  // namespace bslnav
