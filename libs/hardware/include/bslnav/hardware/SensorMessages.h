#pragma once

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <optional>
#include <string>

namespace bslnav {

/** What the process of a driver tells the one that started it: observations, and trouble in words.
 */
struct SensorMessage {
  enum class Kind : char { Observation = 'O', Trouble = 'T' };
  Kind kind = Kind::Trouble;
  std::string bytes;  ///< an observation as MRPT serialises it, or the words
};

SensorMessage messageOf(const mrpt::obs::CObservation& observation);
/** @throws std::exception when the bytes are none */
mrpt::obs::CObservation::Ptr observationOf(const SensorMessage& message);

/** Writes all of a message; false when nobody reads any more. */
bool write(int file, const SensorMessage& message);

/** Puts messages together from bytes as they come. */
class SensorMessageReader {
 public:
  void add(const char* bytes, std::size_t count) { buffer_.append(bytes, count); }
  /** The next one that is complete. @throws std::runtime_error when the bytes make no sense */
  std::optional<SensorMessage> next();

 private:
  std::string buffer_;
};

}  // namespace bslnav
