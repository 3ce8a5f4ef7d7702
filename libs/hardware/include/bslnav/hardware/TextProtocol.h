#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace bslnav {

/* The lines that a base of one's own and its host exchange: `$<letter>,<fields>*<check sum>`. Who
 * writes the base's side reads share/doc/base-protocol.md. */

inline constexpr int kTextVersion = 1;
inline constexpr std::size_t kLongestTextLine = 200;  ///< without its line feed
inline constexpr std::size_t kLongestTextHalt = 60;

/** Host to base, and repeated by the base with what it will keep to. */
struct TextHello {
  int version = kTextVersion;
  int watchdog_ms = 300;  ///< without a valid velocity for so long the base stops by itself
};

/** Host to base: how to drive, in the robot frame. */
struct TextVelocity {
  mrpt::math::TTwist2D twist;
};

/** Host to base: stop as hard as it goes. */
struct TextStop {};

/** Base to host. */
struct TextState {
  std::uint32_t time_ms = 0;  ///< the base's own clock; it may overflow
  mrpt::math::TPose2D odometry;
  mrpt::math::TTwist2D twist;
  std::string halt;  ///< printable ASCII but for `$`, `*` and `,`, at most kLongestTextHalt of them
  std::optional<mrpt::math::TPose2D> mapFromRobot;
};

using TextMessage = std::variant<TextHello, TextVelocity, TextStop, TextState>;

/** With check sum and line feed; lengths with four decimals. What a halt may not hold becomes a
 * space. Numbers that are not finite make a line that nobody accepts. */
std::string toTextLine(const TextMessage& message);

/** Nothing unless every byte of the line is as it should be.
 *  @param line without its line feed; a carriage return at its end is allowed */
std::optional<TextMessage> fromTextLine(std::string_view line);

/** Cuts a stream of bytes into lines. */
class TextLines {
 public:
  /** The line that this byte, a line feed, ends. Of one that is too long no more than its beginning
   * is kept, enough to be refused. */
  std::optional<std::string> take(char byte);

 private:
  std::string line_;
};

}  // namespace bslnav
