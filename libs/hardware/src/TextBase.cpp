#include <bslnav/config/ConfigSection.h>
#include <bslnav/config/Error.h>
#include <bslnav/hardware/TextBase.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "DeviceLine.h"

namespace bslnav {
namespace {

constexpr double kSayAgain_s = 0.2;  // a base that is just starting misses the first hello

}  // namespace

void TextBaseParameters::describe(ConfigSection& section) {
  section.text("address", address, "serial device, or tcp:HOST:PORT");
  section.integer("baud", baud, {50, 4e6}, "", "of a serial device");
  section.number("watchdog_s", watchdog_s, {0.05, 2.0}, "s",
                 "without a new velocity for so long the base stops by itself");
  section.number("start_s", start_s, {0.1, 30.0}, "s",
                 "so long is waited for the base's first state; some boards restart when the line "
                 "is opened");
}

TextBase::TextBase(const TextBaseParameters& parameters)
    : parameters_(parameters),
      line_(DeviceLine::open(parameters.address, parameters.baud)),
      reader_(&TextBase::readLines, this) {
  try {
    greet();
  } catch (...) {
    finish();
    throw;
  }
}

TextBase::~TextBase() { finish(); }

void TextBase::finish() noexcept {
  stop();
  {
    const std::lock_guard lock(reading_);
    ending_ = true;
  }
  reader_.join();
}

void TextBase::greet() {
  const auto watchdog_ms = static_cast<int>(std::lround(1e3 * parameters_.watchdog_s));
  double left_s = parameters_.start_s;
  do {
    send(TextHello{kTextVersion, watchdog_ms});
    if (waitForGreeting(std::min(left_s, kSayAgain_s))) return;
    left_s -= kSayAgain_s;
  } while (left_s > 0.0);
  throw Error(parameters_.address,
              "no answer within start_s; expected a base that speaks bslnav's text protocol (one "
              "that restarts when the line is opened needs a longer start_s)",
              Error::Kind::Run);
}

bool TextBase::waitForGreeting(double timeout_s) {
  std::unique_lock lock(reading_);
  heard_.wait_for(lock, std::chrono::duration<double>(timeout_s),
                  [this] { return gone_ || (hello_ && state_); });
  if (gone_) throw *gone_;
  if (hello_ && hello_->version != kTextVersion)
    throw Error(parameters_.address,
                "speaks version " + std::to_string(hello_->version) +
                    " of the text protocol; expected " + std::to_string(kTextVersion),
                Error::Kind::Run);
  if (hello_ && hello_->watchdog_ms > 1e3 * parameters_.watchdog_s + 1.0)
    throw Error(parameters_.address,
                "its watchdog takes " + std::to_string(hello_->watchdog_ms) +
                    " ms; expected watchdog_s at most",
                Error::Kind::Run);
  return hello_ && state_;
}

BaseState TextBase::state() {
  const std::lock_guard lock(reading_);
  if (gone_) throw *gone_;
  return *state_;
}

void TextBase::drive(const mrpt::math::TTwist2D& command) {
  if (!std::isfinite(command.vx) || !std::isfinite(command.vy) || !std::isfinite(command.omega)) {
    stop();
    throw Error(parameters_.address, "was given a velocity that is not finite", Error::Kind::Run);
  }
  send(TextVelocity{command});
}

void TextBase::stop() noexcept {
  try {
    send(TextStop());
  } catch (const std::exception&) {
    // Then the base hears nothing more, and its watchdog stops it.
  }
}

}  // namespace bslnav
