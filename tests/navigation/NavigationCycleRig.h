#pragma once

#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace bslnav::test {

inline constexpr double kStart_s = 1e9, kPeriod_s = 0.1;

/** A scan of 181 beams, one a degree from the right to the left; a range of 0 makes a beam without
 * return. @param range_m of a bearing in degrees */
inline mrpt::obs::CObservation2DRangeScan::Ptr makeScan(double time_s,
                                                        const std::function<double(int)>& range_m) {
  auto scan = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
  scan->timestamp = mrpt::Clock::fromDouble(kStart_s + time_s);
  scan->aperture = static_cast<float>(M_PI);
  scan->maxRange = 5.6f;
  scan->resizeScan(181);
  for (int i = 0; i <= 180; ++i) {
    const double range = range_m(i - 90);
    scan->setScanRange(static_cast<std::size_t>(i), static_cast<float>(range));
    scan->setScanRangeValidity(static_cast<std::size_t>(i), range != 0.0);
  }
  return scan;
}

/** A free map between the corners, with an occupied border of a cell. */
inline std::shared_ptr<mrpt::maps::COccupancyGridMap2D> makeMap(double x0, double y0, double x1,
                                                                double y1) {
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(x0, x1, y0, y1, 0.05f);
  map->fill(0.95f);
  const int w = static_cast<int>(map->getSizeX()), h = static_cast<int>(map->getSizeY());
  for (int x = 0; x < w; ++x) map->setCell(x, 0, 0.05f), map->setCell(x, h - 1, 0.05f);
  for (int y = 0; y < h; ++y) map->setCell(0, y, 0.05f), map->setCell(w - 1, y, 0.05f);
  return map;
}

inline void occupy(mrpt::maps::COccupancyGridMap2D& map, double x0, double y0, double x1,
                   double y1) {
  for (int y = map.y2idx(y0); y <= map.y2idx(y1); ++y)
    for (int x = map.x2idx(x0); x <= map.x2idx(x1); ++x) map.setCell(x, y, 0.05f);
}

inline NavigationParameters method(int number) {
  NavigationParameters parameters;
  parameters.dwa.weights.velocity = 0.0;
  if (number == 2) parameters.blindSpots.source = BlindSpotSource::ScanJumps;
  return parameters;
}

/** A navigation cycle and a robot that does exactly as it is told, in a world that the laser sees
 * nothing of unless `range_m` says so. */
class CycleRig {
 public:
  explicit CycleRig(const NavigationParameters& parameters = method(1),
                    std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map = nullptr)
      : cycle(parameters, std::move(map)), limits_(parameters.limits) {}

  SensorFrame frame() const {
    SensorFrame frame;
    frame.time_s = time_s;
    frame.startTime_s = kStart_s;
    frame.odometry = frame.mapFromRobot = pose;
    frame.twist = twist;
    frame.scans = {makeScan(time_s, range_m)};
    return frame;
  }

  /** Runs a cycle; every command keeps the limits. Then the robot moves on. */
  const CycleRecord& step(const SensorFrame& frame) {
    const CycleRecord& record = cycle.step(frame);
    const auto& command = record.motion.command;
    const auto allowed = limited(command, twist, limits_, kPeriod_s);
    EXPECT_NEAR(command.vx, allowed.vx, 1e-9) << "at " << time_s;
    EXPECT_NEAR(command.vy, allowed.vy, 1e-9) << "at " << time_s;
    EXPECT_NEAR(command.omega, allowed.omega, 1e-9) << "at " << time_s;
    twist = command;
    const double middle = pose.phi + 0.5 * twist.omega * kPeriod_s;
    const double ahead = twist.vx * kPeriod_s, left = twist.vy * kPeriod_s;
    pose.x += ahead * std::cos(middle) - left * std::sin(middle);
    pose.y += ahead * std::sin(middle) + left * std::cos(middle);
    pose.phi += twist.omega * kPeriod_s;
    time_s += kPeriod_s;
    return record;
  }
  const CycleRecord& step() { return step(frame()); }

  void drive(int cycles) {
    for (int i = 0; i < cycles; ++i) step();
  }
  bool driveUntil(MotionMode mode, double seconds) {
    for (const double end_s = time_s + seconds; time_s < end_s;)
      if (step().motion.mode == mode) return true;
    return false;
  }

  NavigationCycle cycle;
  mrpt::math::TPose2D pose;
  mrpt::math::TTwist2D twist;
  double time_s = 0.0;
  std::function<double(int)> range_m = [](int) { return 0.0; };

 private:
  RobotLimits limits_;
};

}  // namespace bslnav::test
