#pragma once

#include <bslnav/navigation/SensorFrame.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation.h>

#include <string>

namespace bslnav {

/** Records what a robot senses as an MRPT rawlog of single observations, compressed.
 *
 * A control cycle is its scans and depth observations as they are, then the odometry with its twist
 * (label `odometry`), then where the robot was localised (label `localization`); the last two carry
 * the cycle's time, to the 100 ns of MRPT's clock. `RawlogFraming::RecordedPoses` reads it back. */
class RunRawlog {
 public:
  /** @throws Error (Run) when the file cannot be written */
  explicit RunRawlog(std::string file);

  /** Records one control cycle. @throws Error (Run) when it cannot be written */
  void write(const SensorFrame& frame);

 private:
  void add(const mrpt::obs::CObservation& observation);

  std::string file_;
  mrpt::io::CFileGZOutputStream stream_;
};

}  // namespace bslnav
