#include <bslnav/config/Error.h>
#include <bslnav/navigation/RawlogReader.h>
#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "RawlogFrames.h"

namespace bslnav {
namespace {

using mrpt::math::TTwist2D;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationOdometry;

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

void take(const mrpt::obs::CActionCollection& actions, RawlogFrames& frames) {
  const auto movement = actions.getActionByClass<CActionRobotMovement2D>();
  if (!movement) return;
  const bool isOdometry = movement->estimationMethod == CActionRobotMovement2D::emOdometry;
  const auto increment = isOdometry || !movement->poseChange ? movement->rawOdometryIncrementReading
                                                             : movement->poseChange->getMeanVal();
  frames.addIncrement(increment.asTPose(),
                      reportedTwist(movement->hasVelocities, movement->velocityLocal));
}

void take(const CObservationOdometry& reading, RawlogFrames& frames) {
  std::optional<double> stamp_s;
  if (reading.timestamp != INVALID_TIMESTAMP) stamp_s = mrpt::Clock::toDouble(reading.timestamp);
  frames.addReading(reading.odometry.asTPose(), stamp_s,
                    reportedTwist(reading.hasVelocities, reading.velocityLocal));
}

void take(const mrpt::obs::CSensoryFrame& sensoryFrame, RawlogFrames& frames) {
  RawlogFrames::Scans scans;
  for (const auto& observation : sensoryFrame) {
    if (const auto* reading = dynamic_cast<const CObservationOdometry*>(observation.get()))
      take(*reading, frames);
    if (auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(observation))
      scans.push_back(std::move(scan));
  }
  if (!scans.empty()) frames.addScans(std::move(scans));
}

}  // namespace

/* CRawlog::getActionObservationPairOrObservation() skips a sensory frame before the first action
 * and does not tell the end of the file from a damaged record, so the objects are read one by one.
 */
struct RawlogReader::Stream {
  Stream(const std::string& file, double gap_s) : frames(gap_s) {
    if (!input.open(file)) throw Error(file, "cannot be opened; expected a rawlog");
    archive = mrpt::serialization::archiveUniquePtrFrom(input);
  }

  void readUntilReady() {
    while (frames.ready.empty() && !ended) readEntry();
  }

  void readEntry() {
    const auto start = input.getPosition();
    mrpt::serialization::CSerializable::Ptr object;
    try {
      object = archive->ReadObject();
    } catch (const std::exception&) {  // its text is MRPT's source line and a backtrace: nothing
                                       // for the user
      ended = true;
      frames.statistics.truncated = input.getPosition() != start;
      if (frames.statistics.truncated)
        frames.statistics.truncatedAtRecord = frames.statistics.entries;
      return frames.finish();
    }
    ++frames.statistics.entries;
    if (const auto* actions = dynamic_cast<const mrpt::obs::CActionCollection*>(object.get()))
      take(*actions, frames);
    else if (const auto* sensoryFrame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(object.get()))
      take(*sensoryFrame, frames);
    else if (const auto* reading = dynamic_cast<const CObservationOdometry*>(object.get()))
      take(*reading, frames);
    else if (auto scan = std::dynamic_pointer_cast<CObservation2DRangeScan>(object))
      frames.addScans({std::move(scan)});
  }

  mrpt::io::CFileGZInputStream input;
  mrpt::serialization::CArchive::UniquePtr archive;
  RawlogFrames frames;
  bool ended = false;
};

RawlogReader::RawlogReader(const std::string& file, double gap_s) {
  namespace fs = std::filesystem;
  if (!fs::is_regular_file(file)) throw Error(file, "no such file; expected a rawlog");
  if (fs::file_size(file) == 0) throw Error(file, "is empty; expected a rawlog", Error::Kind::Run);
  stream_ = std::make_unique<Stream>(file, gap_s);
  stream_->readUntilReady();
  if (!stream_->frames.ready.empty()) return;
  if (stream_->frames.statistics.entries == 0)
    throw Error(file, "is not a rawlog, or its first record is cut off or of an unknown class",
                Error::Kind::Run);
  throw Error(file,
              "has no 2D laser scan in " + std::to_string(stream_->frames.statistics.entries) +
                  " records; expected CObservation2DRangeScan",
              Error::Kind::Run);
}

RawlogReader::~RawlogReader() = default;
RawlogReader::RawlogReader(RawlogReader&&) noexcept = default;
RawlogReader& RawlogReader::operator=(RawlogReader&&) noexcept = default;

bool RawlogReader::next(SensorFrame& frame) {
  stream_->readUntilReady();
  if (stream_->frames.ready.empty()) return false;
  frame = std::move(stream_->frames.ready.front());
  stream_->frames.ready.pop_front();
  return true;
}

const RawlogStatistics& RawlogReader::statistics() const { return stream_->frames.statistics; }

}  // namespace bslnav
