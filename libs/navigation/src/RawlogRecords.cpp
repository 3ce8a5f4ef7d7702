#include "RawlogRecords.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace bslnav {
namespace {

using mrpt::math::TTwist2D;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservationOdometry;
using mrpt::obs::CObservationRobotPose;

/** The velocities of an entry, if it has any that a robot can have.
 *
 * Logs of old MRPT versions (localization_demo.rawlog) hold uninitialised memory in flag and
 * velocities, so the flag is read as a byte. */
std::optional<TTwist2D> reportedTwist(const bool& hasVelocities, const TTwist2D& twist) {
  constexpr double kHighest = 50.0;  // m/s, rad/s
  unsigned char flag = 0;
  std::memcpy(&flag, &hasVelocities, 1);
  const auto plausible = [](double value) { return std::abs(value) < kHighest; };  // NaN is not
  if (flag != 1 || !plausible(twist.vx) || !plausible(twist.vy) || !plausible(twist.omega))
    return std::nullopt;
  return twist;
}

void takeActions(const mrpt::obs::CActionCollection& actions, RawlogFrames& frames) {
  const auto movement = actions.getActionByClass<CActionRobotMovement2D>();
  if (!movement) return;
  const bool isOdometry = movement->estimationMethod == CActionRobotMovement2D::emOdometry;
  const auto increment = isOdometry || !movement->poseChange ? movement->rawOdometryIncrementReading
                                                             : movement->poseChange->getMeanVal();
  frames.addIncrement(increment.asTPose(),
                      reportedTwist(movement->hasVelocities, movement->velocityLocal));
}

void takeReading(const CObservationOdometry& reading, RawlogFrames& frames) {
  std::optional<double> stamp_s;
  if (reading.timestamp != INVALID_TIMESTAMP) stamp_s = mrpt::Clock::toDouble(reading.timestamp);
  frames.addReading(reading.odometry.asTPose(), stamp_s,
                    reportedTwist(reading.hasVelocities, reading.velocityLocal));
}

void takePose(const CObservationRobotPose& pose, RawlogFrames& frames) {
  if (pose.timestamp == INVALID_TIMESTAMP) return;
  frames.addPose(mrpt::math::TPose2D(pose.pose.mean.asTPose()), pose.timestamp);
}

/** Sorts an object among the measurements, if it is one. */
void addTo(RawlogMeasurements& measurements,
           const mrpt::serialization::CSerializable::Ptr& object) {
  using mrpt::obs::CObservation2DRangeScan;
  using mrpt::obs::CObservation3DRangeScan;
  if (auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(object))
    measurements.scans.push_back(std::move(scan));
  else if (auto depth = std::dynamic_pointer_cast<CObservation3DRangeScan>(object))
    measurements.depth.push_back(std::move(depth));
}

}  // namespace

void take(const mrpt::serialization::CSerializable::Ptr& object, RawlogFrames& frames) {
  RawlogMeasurements measurements;
  const auto takeObservation = [&](const mrpt::serialization::CSerializable::Ptr& observation) {
    if (const auto* reading = dynamic_cast<const CObservationOdometry*>(observation.get()))
      takeReading(*reading, frames);
    else if (const auto* pose = dynamic_cast<const CObservationRobotPose*>(observation.get()))
      takePose(*pose, frames);
    else
      addTo(measurements, observation);
  };
  if (const auto* actions = dynamic_cast<const mrpt::obs::CActionCollection*>(object.get()))
    takeActions(*actions, frames);
  else if (const auto* sensoryFrame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(object.get()))
    for (const auto& observation : *sensoryFrame) takeObservation(observation);
  else
    takeObservation(object);
  frames.addMeasurements(std::move(measurements));
}

}  // namespace bslnav
