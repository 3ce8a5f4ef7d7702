#include <bslnav/hardware/CreateProtocol.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bslnav {
namespace {

// What a frame looks like; kData stands where the robot's values are.
constexpr int kData = -1;
constexpr std::array<int, 21> kFrame{19,    18,                              // header, length
                                     7,     kData, 9,     kData, 10, kData,  // bumps, cliffs
                                     11,    kData, 12,    kData, 35, kData,  // cliffs, mode
                                     43,    kData, kData, 44,                // left, right counts
                                     kData, kData, kData};                   // checksum
constexpr std::size_t kBumps = 3, kMode = 13, kLeft = 15, kRight = 18;
constexpr std::array<std::size_t, 4> kCliffs{5, 7, 9, 11};

unsigned at(std::string_view bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

bool beginsFrame(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (kFrame[i] != kData && at(bytes, i) != static_cast<unsigned>(kFrame[i])) return false;
  return true;
}

std::uint16_t word(std::string_view bytes, std::size_t i) {
  return static_cast<std::uint16_t>(at(bytes, i) << 8 | at(bytes, i + 1));
}

CreateSensors sensorsIn(std::string_view frame) {
  CreateSensors sensors;
  const unsigned bumps = at(frame, kBumps);
  sensors.bumpRight = (bumps & 1) != 0;
  sensors.bumpLeft = (bumps & 2) != 0;
  sensors.wheelDrop = (bumps & 12) != 0;
  sensors.cliff =
      std::any_of(kCliffs.begin(), kCliffs.end(), [&](auto i) { return at(frame, i) != 0; });
  sensors.mode = static_cast<int>(at(frame, kMode));
  sensors.leftCounts = word(frame, kLeft);
  sensors.rightCounts = word(frame, kRight);
  return sensors;
}

std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result += static_cast<char>(value);
  return result;
}

}  // namespace

std::string CreateSensors::halt() const {
  if (wheelDrop) return "wheel drop: lifted, or over an edge";
  if (cliff) return "cliff";
  if (bump()) return bumpLeft && bumpRight ? "bump ahead" : bumpLeft ? "bump left" : "bump right";
  if (!takesCommands()) return "takes no commands: Open Interface mode " + std::to_string(mode);
  return {};
}

namespace create {

std::string start() { return bytes({128}); }

std::string safe() { return bytes({131}); }

std::string driveDirect(const CreateWheels& wheels) {
  const auto mmps = [](double speed_mps) {
    return static_cast<int>(std::lround(1e3 * std::clamp(speed_mps, -0.5, 0.5)));
  };
  const int right = mmps(wheels.right_mps), left = mmps(wheels.left_mps);
  return bytes({145, right >> 8, right, left >> 8, left});
}

std::string stream() { return bytes({148, 8, 7, 9, 10, 11, 12, 35, 43, 44}); }

std::string fullStop() { return driveDirect({}) + driveDirect({}); }

std::uint8_t checksum(std::string_view frame) {
  unsigned sum = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) sum += at(frame, i);
  return static_cast<std::uint8_t>(256 - sum % 256);
}

}  // namespace create

std::optional<CreateSensors> CreateFrameParser::feed(std::uint8_t byte) {
  bytes_ += static_cast<char>(byte);
  std::optional<CreateSensors> found;
  if (bytes_.size() == kFrame.size() && beginsFrame(bytes_)) {
    if (create::checksum(bytes_) == 0) {
      found = sensorsIn(bytes_);
      bytes_.clear();
    } else {
      ++badChecksums_;
      bytes_.erase(0, 1);
    }
  }
  while (!beginsFrame(bytes_)) bytes_.erase(0, 1);
  return found;
}

}  // namespace bslnav
