#include "CreateRobot.h"

#include <cmath>
#include <numeric>

namespace bslnav::test {
namespace {

constexpr double kCountsPerMetre = 508.8 / (M_PI * 0.072);

unsigned at(std::string_view bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

double speedAt(std::string_view bytes, std::size_t i) {
  return 1e-3 * static_cast<std::int16_t>(at(bytes, i) << 8 | at(bytes, i + 1));
}

std::string counts(double distance_m) {
  const auto all = static_cast<std::int64_t>(std::floor(distance_m * kCountsPerMetre));
  return {static_cast<char>(all >> 8), static_cast<char>(all)};
}

}  // namespace

std::size_t CreateRobot::commandLength() const {
  switch (at(in_, 0)) {
    case 137:  // Drive
    case 145:  // Drive Direct
      return 5;
    case 148:  // Stream: its data tell how many they are
      return in_.size() < 2 ? 2 : 2 + at(in_, 1);
    case 150:  // Pause and resume
      return 2;
    default:
      return 1;
  }
}

void CreateRobot::take(std::string_view bytes) {
  in_ += bytes;
  while (!in_.empty() && in_.size() >= commandLength()) {
    const std::size_t length = commandLength();
    execute(std::string_view(in_).substr(0, length));
    in_.erase(0, length);
  }
}

void CreateRobot::execute(std::string_view command) {
  const unsigned opcode = at(command, 0);
  if (opcode == 128) {
    mode = Passive;
    wheels = {};
  }
  if (opcode == 131 && mode != Off) mode = Safe;
  if (opcode == 148 && mode != Off) streamed_ = command.substr(2);
  if (opcode != 145) return;
  lastDrive = {speedAt(command, 3), speedAt(command, 1)};
  ++drives;
  if (mode >= Safe) wheels = lastDrive;
}

void CreateRobot::watchFloor() {
  const bool forward = wheels.left_mps + wheels.right_mps > 0.0;
  if (mode != Safe || !(wheelDrop || (cliff && forward))) return;
  mode = Passive;
  wheels = {};
}

std::string CreateRobot::packet(unsigned id) const {
  const auto byte = [](int value) { return std::string(1, static_cast<char>(value)); };
  if (id == 7) return byte((bump ? 3 : 0) + (wheelDrop ? 12 : 0));
  if (id >= 9 && id <= 12) return byte(cliff ? 1 : 0);
  if (id == 35) return byte(mode);
  if (id == 43) return counts(left_m);
  if (id == 44) return counts(right_m);
  return {};
}

std::string CreateRobot::frame() const {
  if (streamed_.empty()) return {};
  std::string data;
  for (const char id : streamed_) data += id + packet(static_cast<unsigned char>(id));
  std::string whole = {19, static_cast<char>(data.size())};
  whole += data;
  const int sum = std::accumulate(whole.begin(), whole.end(), 0);
  return whole + static_cast<char>(-sum);
}

}  // namespace bslnav::test
