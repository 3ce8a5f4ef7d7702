#include <bslnav/navigation/RobotSenses.h>
#include <mrpt/core/Clock.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {

using mrpt::obs::CObservation2DRangeScan;

CObservation2DRangeScan::Ptr scanOf(const mrpt::maps::CSimplePointsMap& points, int beams,
                                    double maxRange_m) {
  auto scan = CObservation2DRangeScan::Create();
  scan->aperture = static_cast<float>(2.0 * M_PI * (1.0 - 1.0 / beams));
  scan->rightToLeft = true;
  scan->maxRange = static_cast<float>(maxRange_m);
  scan->sensorLabel = "obstacles";
  scan->resizeScan(static_cast<std::size_t>(beams));
  std::vector<float> nearest(static_cast<std::size_t>(beams), scan->maxRange);
  for (std::size_t i = 0; i < points.size(); ++i) {
    float x = 0.0f, y = 0.0f;
    points.getPoint(i, x, y);
    const double part = (std::atan2(y, x) + M_PI) / (2.0 * M_PI);
    const auto beam = static_cast<std::size_t>(std::lround(part * beams)) % nearest.size();
    nearest[beam] = std::min(nearest[beam], std::hypot(x, y));
  }
  for (std::size_t beam = 0; beam < nearest.size(); ++beam) {
    const bool hit = nearest[beam] < scan->maxRange, open = points.empty();
    scan->setScanRange(beam, hit || open ? nearest[beam] : std::numeric_limits<float>::quiet_NaN());
    scan->setScanRangeValidity(beam, hit);
  }
  // Beam i looks along -aperture/2 + i·step = -π(1 - 1/n) + 2πi/n; the points were sorted into
  // -π + 2πi/n.
  scan->sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 0.0, -M_PI / beams, 0.0, 0.0);
  return scan;
}

SensorFrame RobotSenses::frame(const mrpt::math::TPose2D& pose, const mrpt::math::TTwist2D& twist,
                               const mrpt::math::TPose2D& odometry, mrpt::system::TTimeStamp stamp,
                               const mrpt::maps::CSimplePointsMap& obstacles,
                               mrpt::system::TTimeStamp obstaclesStamp) {
  constexpr int kBeams =
      360;  // coarser than lasers: a beam without a point between points would be a gap
  constexpr double kMaxRange_m = 50.0;
  SensorFrame frame;
  frame.time_s = robot_.getNavigationTime();
  frame.startTime_s = mrpt::Clock::toDouble(stamp) - frame.time_s;
  frame.odometry = odometry;
  frame.mapFromRobot = pose;
  frame.twist = twist;
  if (auto* source = dynamic_cast<SensorSource*>(&robot_)) {
    source->sense(frame);
    return frame;
  }
  auto scan = scanOf(obstacles, kBeams, kMaxRange_m);
  scan->timestamp = obstaclesStamp == INVALID_TIMESTAMP ? stamp : obstaclesStamp;
  frame.scans.push_back(scan);
  return frame;
}

}  // namespace bslnav
