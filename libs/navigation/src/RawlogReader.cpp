#include <bslnav/config/Error.h>
#include <bslnav/navigation/RawlogReader.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>
#include <utility>

#include "RawlogDepth.h"
#include "RawlogFrames.h"
#include "RawlogRecords.h"
#include "WholeReads.h"

namespace bslnav {

/* CRawlog::getActionObservationPairOrObservation() skips a sensory frame before the first action
 * and does not tell the end of the file from a damaged record, so the objects are read one by one.
 */
struct RawlogReader::Stream {
  Stream(const std::string& file, double gap_s, RawlogFraming framing)
      : frames(gap_s, imagesDirectoryOf(file), framing) {
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
    take(object, frames);
  }

  WholeReads input;
  mrpt::serialization::CArchive::UniquePtr archive;
  RawlogFrames frames;
  bool ended = false;
};

namespace {

/** Why a log that has been read to its end gives no frame. */
std::string whyNoFrame(const RawlogStatistics& statistics, RawlogFraming framing) {
  if (statistics.entries == 0)
    return "is not a rawlog, or its first record is cut off or of an unknown class";
  if (framing == RawlogFraming::RecordedPoses)
    return "has no recorded pose in " + std::to_string(statistics.entries) +
           " records; expected a CObservationRobotPose a control cycle";
  if (statistics.droppedDepthFrames > 0)
    return "has no 2D laser scan, and none of its " +
           std::to_string(statistics.droppedDepthFrames) +
           " depth frames has a range image; the first: " + statistics.firstDroppedDepth;
  return "has neither a 2D laser scan nor a depth frame in " + std::to_string(statistics.entries) +
         " records; expected CObservation2DRangeScan or CObservation3DRangeScan";
}

}  // namespace

RawlogReader::RawlogReader(const std::string& file, double gap_s, RawlogFraming framing) {
  namespace fs = std::filesystem;
  if (!fs::is_regular_file(file)) throw Error(file, "no such file; expected a rawlog");
  if (fs::file_size(file) == 0) throw Error(file, "is empty; expected a rawlog", Error::Kind::Run);
  stream_ = std::make_unique<Stream>(file, gap_s, framing);
  stream_->readUntilReady();
  if (stream_->frames.ready.empty())
    throw Error(file, whyNoFrame(stream_->frames.statistics, framing), Error::Kind::Run);
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
