#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bslnav {

/** Speeds of the two wheels over ground. */
struct CreateWheels {
  double left_mps = 0.0, right_mps = 0.0;

  bool operator==(const CreateWheels& other) const {
    return left_mps == other.left_mps && right_mps == other.right_mps;
  }
};

/** What one frame of the sensor stream tells. */
struct CreateSensors {
  bool bumpLeft = false, bumpRight = false;
  bool wheelDrop = false;                         ///< of any wheel
  bool cliff = false;                             ///< of any of the four sensors
  int mode = 0;                                   ///< 0 off, 1 passive, 2 safe, 3 full
  std::uint16_t leftCounts = 0, rightCounts = 0;  ///< roll over every 29 m

  bool bump() const { return bumpLeft || bumpRight; }
  /** Some firmware counts the modes from 1, so that its 4 is full. */
  bool takesCommands() const { return mode >= 2; }
  /** Why the robot stands, in words; empty: nothing of this holds it. */
  std::string halt() const;
};

/** Bytes of the iRobot Create 2 Open Interface (iRobot's specification, 2018). */
namespace create {

std::string start();  ///< switches the interface on, in passive mode
std::string safe();   ///< takes commands, until a wheel drops or there is a cliff ahead
std::string driveDirect(const CreateWheels& wheels);
/** Asks for a frame every 15 ms: packets 7, 9 to 12, 35, 43 and 44. */
std::string stream();
/** Stops, even where the bytes of a command before it were cut off: the first of the two stops
 * fills that one up. */
std::string fullStop();
/** The byte that makes a frame sum to 0 modulo 256. */
std::uint8_t checksum(std::string_view frame);

}  // namespace create

/** Finds the frames that create::stream() asks for among whatever comes over the line.
 *
 * Bytes that do not fit are dropped one by one, so that neither garbage nor half a frame costs the
 * frame after it. */
class CreateFrameParser {
 public:
  /** The frame that `byte` completes. */
  std::optional<CreateSensors> feed(std::uint8_t byte);

  /** Frames that had the form, but not the sum. */
  std::size_t badChecksums() const { return badChecksums_; }

 private:
  std::string bytes_;  // the beginning of a frame, or empty
  std::size_t badChecksums_ = 0;
};

}  // namespace bslnav
