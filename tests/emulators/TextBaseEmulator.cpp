#include "TextBaseEmulator.h"

#include <limits>
#include <utility>

#include "TextBaseWire.h"

namespace bslnav::test {
namespace {

using namespace std::chrono_literals;

constexpr auto kPeriod = 20ms;

}  // namespace

TextBaseEmulator::TextBaseEmulator(Wire wire)
    : line_(wire == Wire::Tcp ? makeTcpLine() : makeSerialLine()),
      address_(line_->address()),
      thread_(&TextBaseEmulator::run, this) {}

TextBaseEmulator::~TextBaseEmulator() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  thread_.join();
}

mrpt::math::TTwist2D TextBaseEmulator::command() const {
  const std::lock_guard lock(mutex_);
  const bool expired = Clock::now() - commanded_ > std::chrono::milliseconds(watchdog_ms_);
  return expired ? mrpt::math::TTwist2D() : command_;
}

void TextBaseEmulator::run() {
  while (true) {
    bool deaf = false;
    {
      const std::lock_guard lock(mutex_);
      if (ending_) return;
      if (pulled_) break;
      deaf = deaf_;
    }
    if (deaf) std::this_thread::sleep_for(5ms);
    const std::string heard = deaf ? std::string() : line_->read(0.005);
    std::string said;
    {
      const std::lock_guard lock(mutex_);
      take(heard);
      said = std::exchange(toSend_, {}) + nextState();
    }
    if (!said.empty()) line_->write(said);
  }
  line_->hangUp();
  const std::lock_guard lock(mutex_);
  ending_ = true;
}

void TextBaseEmulator::take(const std::string& bytes) {
  for (const char byte : bytes) {
    const auto line = lines_.take(byte);
    if (!line || line->empty()) continue;
    if (const auto message = fromTextLine(*line))
      take(*message);
    else
      ++refused_;
  }
}

void TextBaseEmulator::take(const TextMessage& message) {
  if (const auto* hello = std::get_if<TextHello>(&message)) {
    if (++hellos_ <= toMiss_) return;
    greeted_ = true;
    watchdog_ms_ = hello->watchdog_ms;
    toSend_ += toTextLine(answer_.value_or(*hello));
  } else if (!greeted_) {
    ++refused_;
  } else if (const auto* velocity = std::get_if<TextVelocity>(&message)) {
    command_ = velocity->twist;
    commanded_ = Clock::now();
    stopped_ = false;
  } else if (std::holds_alternative<TextStop>(message)) {
    command_ = {};
    stopped_ = true;
  }
}

std::string TextBaseEmulator::nextState() {
  const auto now = Clock::now();
  if (!greeted_ || now < nextState_) return {};
  nextState_ = now + kPeriod;
  return silent_ ? std::string() : stateLine();
}

std::string TextBaseEmulator::stateLine() const {
  using std::chrono::duration_cast, std::chrono::milliseconds;
  TextState state;
  state.time_ms =
      static_cast<std::uint32_t>(duration_cast<milliseconds>(Clock::now() - started_).count());
  state.odometry = state_.odometry;
  state.twist = state_.twist;
  state.halt = state_.halt;
  state.mapFromRobot = state_.mapFromRobot;
  if (nan_) state.odometry.x = std::numeric_limits<double>::quiet_NaN();
  return toTextLine(state);
}

}  // namespace bslnav::test
