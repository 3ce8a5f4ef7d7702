#include <thread>

#include "TextBaseEmulator.h"
#include "TextBaseWire.h"

// What tests see of the emulated base and do to it.

namespace bslnav::test {

using namespace std::chrono_literals;

bool TextBaseEmulator::stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

void TextBaseEmulator::setState(const BaseState& state) {
  const std::lock_guard lock(mutex_);
  state_ = state;
}

int TextBaseEmulator::hellos() const {
  const std::lock_guard lock(mutex_);
  return hellos_;
}

int TextBaseEmulator::refused() const {
  const std::lock_guard lock(mutex_);
  return refused_;
}

void TextBaseEmulator::pullCable() {
  {
    const std::lock_guard lock(mutex_);
    pulled_ = true;
  }
  eventually([this] {
    const std::lock_guard lock(mutex_);
    return ending_;
  });
}

void TextBaseEmulator::send(const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  toSend_ += bytes;
}

void TextBaseEmulator::beSilent(bool silent) {
  const std::lock_guard lock(mutex_);
  silent_ = silent;
}

void TextBaseEmulator::beDeaf(bool deaf) {
  const std::lock_guard lock(mutex_);
  deaf_ = deaf;
}

void TextBaseEmulator::missHellos(int count) {
  const std::lock_guard lock(mutex_);
  toMiss_ = hellos_ + count;
}

void TextBaseEmulator::tellNan(bool nan) {
  const std::lock_guard lock(mutex_);
  nan_ = nan;
}

void TextBaseEmulator::jumpClock(double seconds) {
  const std::lock_guard lock(mutex_);
  started_ -= std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void TextBaseEmulator::restart() {
  const std::lock_guard lock(mutex_);
  started_ = Clock::now();
  greeted_ = false;
  command_ = {};
}

void TextBaseEmulator::answerWith(const TextHello& hello) {
  const std::lock_guard lock(mutex_);
  answer_ = hello;
}

bool eventually(const std::function<bool()>& what) {
  for (int i = 0; i < 5000 && !what(); ++i) std::this_thread::sleep_for(1ms);
  return what();
}

}  // namespace bslnav::test
