#include <bslnav/navigation/Localization.h>

namespace bslnav {

mrpt::math::TPose2D OdometryLocalization::update(const SensorFrame& frame) {
  if (hasOdometry_ && !frame.afterGap) mapFromRobot_ = mapFromRobot_ + (frame.odometry - odometry_);
  odometry_ = frame.odometry;
  hasOdometry_ = true;
  return mapFromRobot_;
}

}  // namespace bslnav
