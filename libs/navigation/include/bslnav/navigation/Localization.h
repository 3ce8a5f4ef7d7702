#pragma once

#include <bslnav/navigation/SensorFrame.h>
#include <mrpt/math/TPose2D.h>

namespace bslnav {

/** Tells where the robot is in the map, frame by frame. */
class Localization {
 public:
  virtual ~Localization() = default;

  /** Takes the next frame and returns the pose of the robot in the map; only RecordedLocalization
   * reads `frame.mapFromRobot`. */
  virtual mrpt::math::TPose2D update(const SensorFrame& frame) = 0;

  /** Standard deviation of the position; 0 from a localisation that estimates none. */
  virtual double spread_m() const = 0;
};

/** Trusts the odometry: starts at a pose in the map and adds up what the robot has driven, nothing
 * over gaps. */
class OdometryLocalization : public Localization {
 public:
  /** @param initialPose in the map, at the first frame */
  explicit OdometryLocalization(const mrpt::math::TPose2D& initialPose)
      : mapFromRobot_(initialPose) {}

  mrpt::math::TPose2D update(const SensorFrame& frame) override;
  double spread_m() const override { return 0.0; }

 private:
  mrpt::math::TPose2D mapFromRobot_, odometry_;
  bool hasOdometry_ = false;
};

/** Trusts the poses of the frames: those that a log recorded. */
class RecordedLocalization : public Localization {
 public:
  mrpt::math::TPose2D update(const SensorFrame& frame) override { return frame.mapFromRobot; }
  double spread_m() const override { return 0.0; }
};

}  // namespace bslnav
