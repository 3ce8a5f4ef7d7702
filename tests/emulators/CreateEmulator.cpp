#include "CreateEmulator.h"

#include <algorithm>
#include <utility>

namespace bslnav::test {
namespace {

using Clock = std::chrono::steady_clock;
using Lock = std::lock_guard<std::mutex>;

constexpr auto kPeriod = std::chrono::milliseconds(15);
// Where nobody reads, bytes are lost, as on a wire; the robot does not wait for them to be read.
constexpr double kWriteTimeout_s = 0.001;

}  // namespace

CreateEmulator::CreateEmulator(std::unique_ptr<PseudoTerminal> line, std::uint32_t seed)
    : line_(std::move(line)), random_(seed), thread_(&CreateEmulator::run, this) {}

CreateEmulator::~CreateEmulator() {
  ending_ = true;
  thread_.join();
}

void CreateEmulator::run() {
  auto due = Clock::now() + kPeriod;
  while (!ending_ && !pulled_) {
    const std::chrono::duration<double> left = due - Clock::now();
    obey(line_->read(std::max(0.0, left.count()) + 1e-3));  // poll() cuts to whole ms
    if (Clock::now() < due) continue;
    due = std::max(due + kPeriod, Clock::now());
    line_->write(nextBytes(), kWriteTimeout_s);
  }
  line_->hangUp();
}

void CreateEmulator::obey(const std::string& bytes) {
  const Lock lock(mutex_);
  robot_.take(bytes);
  robot_.watchFloor();
  if (robot_.drives == drive_.count) return;
  drive_ = {robot_.lastDrive, Clock::now(), robot_.drives};
}

std::string CreateEmulator::nextBytes() {
  const Lock lock(mutex_);
  std::string bytes;
  for (; garbage_ > 0; --garbage_) bytes += static_cast<char>(random_());
  std::string frame = silent_ ? std::string() : robot_.frame();
  if (frame.empty()) return bytes;
  if (std::exchange(damage_, false)) ++frame[frame.size() - 2];
  if (std::exchange(halve_, false)) frame.resize(frame.size() / 2);
  return bytes + frame;
}

CreateEmulator::Wheels CreateEmulator::wheels() const {
  const Lock lock(mutex_);
  return robot_.wheels;
}

CreateEmulator::Drive CreateEmulator::lastDrive() const {
  const Lock lock(mutex_);
  return drive_;
}

CreateRobot::Mode CreateEmulator::mode() const {
  const Lock lock(mutex_);
  return robot_.mode;
}

void CreateEmulator::moved(double left_m, double right_m) {
  const Lock lock(mutex_);
  robot_.left_m += left_m;
  robot_.right_m += right_m;
}

void CreateEmulator::setBump(bool pressed) {
  const Lock lock(mutex_);
  robot_.bump = pressed;
}

void CreateEmulator::setCliff(bool seen) {
  const Lock lock(mutex_);
  robot_.cliff = seen;
}

void CreateEmulator::setWheelDrop(bool dropped) {
  const Lock lock(mutex_);
  robot_.wheelDrop = dropped;
}

void CreateEmulator::pullCable() { pulled_ = true; }

void CreateEmulator::sendGarbage(std::size_t count) {
  const Lock lock(mutex_);
  garbage_ += count;
}

void CreateEmulator::halveNextFrame() {
  const Lock lock(mutex_);
  halve_ = true;
}

void CreateEmulator::damageNextFrame() {
  const Lock lock(mutex_);
  damage_ = true;
}

void CreateEmulator::goSilent(bool silent) {
  const Lock lock(mutex_);
  silent_ = silent;
}

}  // namespace bslnav::test
