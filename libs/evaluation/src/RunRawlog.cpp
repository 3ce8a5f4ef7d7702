#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RunRawlog.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <utility>

namespace bslnav {
namespace {

/** Clock::fromDouble() gives multiples of 1.6 us: seconds since 1601 in a double. */
mrpt::Clock::time_point stampOf(const SensorFrame& frame) {
  const auto ticks = std::llround(frame.time_s * 1e7);
  return mrpt::Clock::fromDouble(frame.startTime_s) + mrpt::Clock::duration(ticks);
}

}  // namespace

RunRawlog::RunRawlog(std::string file) : file_(std::move(file)) {
  constexpr int kCompression = 1;  // fast: most of it are depth images, and noise
  if (!stream_.open(file_, kCompression)) throw Error(file_, "cannot be written", Error::Kind::Run);
}

void RunRawlog::add(const mrpt::obs::CObservation& observation) try {
  mrpt::serialization::archiveFrom(stream_) << observation;
} catch (const std::exception&) {  // its text is MRPT's source line and a backtrace
  throw Error(file_, "cannot be written", Error::Kind::Run);
}

void RunRawlog::write(const SensorFrame& frame) {
  for (const auto& scan : frame.scans) add(*scan);
  for (const auto& depth : frame.depth) add(*depth);

  mrpt::obs::CObservationOdometry odometry;
  odometry.sensorLabel = "odometry";
  odometry.timestamp = stampOf(frame);
  odometry.odometry = mrpt::poses::CPose2D(frame.odometry);
  odometry.hasVelocities = true;
  odometry.velocityLocal = frame.twist;
  add(odometry);

  mrpt::obs::CObservationRobotPose pose;
  pose.sensorLabel = "localization";
  pose.timestamp = odometry.timestamp;
  pose.pose.mean = mrpt::poses::CPose3D(mrpt::math::TPose3D(frame.mapFromRobot));
  add(pose);
}

}  // namespace bslnav
