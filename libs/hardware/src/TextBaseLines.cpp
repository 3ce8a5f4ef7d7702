#include <bslnav/hardware/TextBase.h>
#include <mrpt/core/Clock.h>
#include <mrpt/math/wrap2pi.h>

#include "DeviceLine.h"

// What TextBase writes to its line and reads from it.

namespace bslnav {
namespace {

constexpr double kWrite_s = 0.05;  // for so long a base that takes nothing may hold up a command
constexpr double kRead_s = 0.05;   // for so long the reader may take to end

mrpt::math::TPose2D wrapped(mrpt::math::TPose2D pose) {
  pose.phi = mrpt::math::wrapToPi(pose.phi);
  return pose;
}

}  // namespace

void TextBase::send(const TextMessage& message) {
  {
    const std::lock_guard lock(reading_);
    if (gone_) throw *gone_;
  }
  const std::lock_guard lock(writing_);
  const std::string bytes = (cutShort_ ? "\n" : "") + toTextLine(message);
  cutShort_ = line_->write(bytes, kWrite_s) < bytes.size();
  if (cutShort_)
    throw Error(parameters_.address, "takes no more lines; expected a base that reads them",
                Error::Kind::Run);
}

void TextBase::readLines() noexcept {
  try {
    while (true) {
      const std::string bytes = line_->read(kRead_s);
      const double now_s = mrpt::Clock::nowDouble();
      const std::lock_guard lock(reading_);
      if (ending_) return;
      take(bytes, now_s);
    }
  } catch (const Error& error) {
    const std::lock_guard lock(reading_);
    gone_ = error;
  }
  heard_.notify_all();
}

void TextBase::take(const std::string& bytes, double now_s) {
  for (const char byte : bytes) {
    const auto line = lines_.take(byte);
    if (!line || line->empty() || *line == "\r") continue;
    if (const auto message = fromTextLine(*line))
      take(*message, now_s);
    else
      ++counts_.refused;
  }
}

void TextBase::take(const TextMessage& message, double now_s) {
  if (const auto* hello = std::get_if<TextHello>(&message)) {
    hello_ = *hello;
  } else if (const auto* state = std::get_if<TextState>(&message)) {
    state_ = BaseState{clock_.stamp_s(state->time_ms, now_s), wrapped(state->odometry),
                       state->twist, state->halt, state->mapFromRobot};
    if (state_->mapFromRobot) state_->mapFromRobot = wrapped(*state_->mapFromRobot);
    ++counts_.states;
  } else {
    ++counts_.refused;  // what only a host says, as on a line that returns what it is sent
    return;
  }
  heard_.notify_all();
}

TextLineCounts TextBase::counts() const {
  const std::lock_guard lock(reading_);
  return counts_;
}

}  // namespace bslnav
