#include "ScipEmulator.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

namespace bslnav::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kWhole = std::numeric_limits<std::size_t>::max();
// Longer than a driver takes between two reads; then the rest of a packet is lost, as in a device
// whose buffer is full.
constexpr double kWriteTimeout_s = 0.05;

}  // namespace

ScipEmulator::ScipEmulator(const ScipModel& model, unsigned seed)
    : model_(model),
      laser_(model),
      ranges_m_(static_cast<std::size_t>(model.beams()), std::numeric_limits<float>::infinity()),
      measured_m_(ranges_m_),
      keptBytes_(kWhole),
      dice_(seed),
      thread_([this] { run(); }) {}

ScipEmulator::~ScipEmulator() { stop(); }

void ScipEmulator::stop() {
  stopped_ = true;
  if (thread_.joinable()) thread_.join();
}

void ScipEmulator::pullCable() {
  stop();  // the thread may be waiting at the line that is about to go
  line_.hangUp();
}

void ScipEmulator::setRanges(std::vector<float> ranges_m) {
  const std::lock_guard lock(mutex_);
  if (ranges_m.size() != ranges_m_.size())
    throw std::invalid_argument("ScipEmulator: one range a step, " +
                                std::to_string(ranges_m_.size()));
  ranges_m_ = std::move(ranges_m);
}

void ScipEmulator::freeze(Frozen frozen) {
  const std::lock_guard lock(mutex_);
  frozen_ = frozen;
}

void ScipEmulator::goSilent(bool silent) {
  const std::lock_guard lock(mutex_);
  silent_ = silent;
}

void ScipEmulator::restart() {
  const std::lock_guard lock(mutex_);
  laser_.answer("RS");
}

void ScipEmulator::cutNextPacket(std::size_t kept) {
  const std::lock_guard lock(mutex_);
  keptBytes_ = kept;
}

void ScipEmulator::halveNextPacket() {
  const std::lock_guard lock(mutex_);
  keptShare_ = 0.5;
}

void ScipEmulator::garbleNextPacket(double share) {
  const std::lock_guard lock(mutex_);
  garbledShare_ = share;
}

void ScipEmulator::sendGarbage(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  garbage_ += bytes;
}

void ScipEmulator::run() {
  const std::chrono::duration<double> period(model_.period_s());
  std::chrono::duration<double> next = Clock::now().time_since_epoch() + period;
  while (!stopped_) {
    const std::chrono::duration<double> now = Clock::now().time_since_epoch();
    listen(std::max(0.0, (next - now).count()));
    std::string packet;
    // Turns that a loaded machine came too late for are gone: the mirror does not wait.
    for (; next <= Clock::now().time_since_epoch(); next += period) packet = nextPacket();
    if (packet.empty()) continue;
    damage(packet);
    line_.write(packet, kWriteTimeout_s);
  }
}

void ScipEmulator::listen(double timeout_s) {
  const auto heard = line_.read(timeout_s);
  std::string answers;
  {
    const std::lock_guard lock(mutex_);
    if (silent_) return;
    input_ += heard;
    for (auto end = input_.find('\n'); end != std::string::npos; end = input_.find('\n')) {
      answers += laser_.answer(std::string_view(input_).substr(0, end));
      input_.erase(0, end + 1);
    }
  }
  if (!answers.empty()) line_.write(answers, kWriteTimeout_s);
}

std::string ScipEmulator::nextPacket() {
  const std::lock_guard lock(mutex_);
  if (frozen_ == Frozen::Not) measured_m_ = ranges_m_;
  auto packet = laser_.turn(measured_m_);
  if (packet.empty() || silent_) return {};
  if (frozen_ == Frozen::Packet && !lastPacket_.empty()) packet = lastPacket_;
  lastPacket_ = packet;
  return packet;
}

void ScipEmulator::damage(std::string& packet) {
  const std::lock_guard lock(mutex_);
  if (garbledShare_ > 0.0) {
    std::bernoulli_distribution hit(garbledShare_);
    std::uniform_int_distribution<int> character(0x30, 0x6f);
    for (auto at = packet.find('\n', packet.find("99b")) + 7; at + 2 < packet.size(); ++at)
      if (packet[at] != '\n' && hit(dice_)) packet[at] = static_cast<char>(character(dice_));
  }
  packet.resize(
      std::min({packet.size(), keptBytes_,
                static_cast<std::size_t>(keptShare_ * static_cast<double>(packet.size()))}));
  std::uniform_int_distribution<int> byte(0, 255);
  std::string noise(garbage_, '\0');
  for (auto& c : noise) c = static_cast<char>(byte(dice_));
  packet.insert(0, noise);
  garbledShare_ = 0.0;
  keptShare_ = 1.0;
  keptBytes_ = kWhole;
  garbage_ = 0;
}

}  // namespace bslnav::test
