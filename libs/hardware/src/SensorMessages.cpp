#include <bslnav/hardware/SensorMessages.h>
#include <mrpt/serialization/CSerializable.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace bslnav {
namespace {

// One machine writes and reads, so numbers are as the machine has them.
struct Header {
  char kind;
  std::uint32_t count;
};
constexpr std::size_t kHeader = sizeof(char) + sizeof(std::uint32_t);
constexpr std::uint32_t kMost = 256u << 20u;  // far above any image

}  // namespace

SensorMessage messageOf(const mrpt::obs::CObservation& observation) {
  std::vector<std::uint8_t> bytes;
  mrpt::serialization::ObjectToOctetVector(&observation, bytes);
  return {SensorMessage::Kind::Observation, std::string(bytes.begin(), bytes.end())};
}

mrpt::obs::CObservation::Ptr observationOf(const SensorMessage& message) {
  const std::vector<std::uint8_t> bytes(message.bytes.begin(), message.bytes.end());
  mrpt::serialization::CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject(bytes, object);
  auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object);
  if (!observation) throw std::runtime_error("the driver delivered something not an observation");
  return observation;
}

bool write(int file, const SensorMessage& message) {
  const auto count = static_cast<std::uint32_t>(message.bytes.size());
  std::string all(kHeader, '\0');
  all[0] = static_cast<char>(message.kind);
  std::memcpy(&all[1], &count, sizeof(count));
  all += message.bytes;
  for (std::size_t written = 0; written < all.size();) {
    const auto more = ::write(file, all.data() + written, all.size() - written);
    if (more < 0 && errno != EINTR) return false;
    if (more > 0) written += static_cast<std::size_t>(more);
  }
  return true;
}

std::optional<SensorMessage> SensorMessageReader::next() {
  if (buffer_.size() < kHeader) return std::nullopt;
  Header header{buffer_[0], 0};
  std::memcpy(&header.count, &buffer_[1], sizeof(header.count));
  const bool known = header.kind == static_cast<char>(SensorMessage::Kind::Observation) ||
                     header.kind == static_cast<char>(SensorMessage::Kind::Trouble);
  if (!known || header.count > kMost)
    throw std::runtime_error("what the driver's process wrote makes no sense");
  if (buffer_.size() < kHeader + header.count) return std::nullopt;
  SensorMessage message{static_cast<SensorMessage::Kind>(header.kind),
                        buffer_.substr(kHeader, header.count)};
  buffer_.erase(0, kHeader + header.count);
  return message;
}

}  // namespace bslnav
