#include <bslnav/hardware/TextProtocol.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "TextFields.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

std::string lineOf(const std::string& payload) {
  return '$' + payload + '*' + checkSum(payload) + '\n';
}

std::string fields(double a, double b, double c) {
  return ',' + decimal(a) + ',' + decimal(b) + ',' + decimal(c);
}

std::string speakable(std::string halt) {
  halt.resize(std::min(halt.size(), kLongestTextHalt));
  std::replace_if(
      halt.begin(), halt.end(), [](char c) { return !isPayload(c) || c == ','; }, ' ');
  return halt;
}

struct ToLine {
  std::string operator()(const TextHello& hello) const {
    return lineOf("H," + std::to_string(hello.version) + ',' + std::to_string(hello.watchdog_ms));
  }
  std::string operator()(const TextVelocity& velocity) const {
    return lineOf('V' + fields(velocity.twist.vx, velocity.twist.vy, velocity.twist.omega));
  }
  std::string operator()(const TextStop&) const { return lineOf("X"); }
  std::string operator()(const TextState& state) const {
    std::string payload = "S," + std::to_string(state.time_ms);
    payload += fields(state.odometry.x, state.odometry.y, state.odometry.phi);
    payload += fields(state.twist.vx, state.twist.vy, state.twist.omega);
    if (!state.halt.empty() || state.mapFromRobot) payload += ',' + speakable(state.halt);
    if (const auto& pose = state.mapFromRobot) payload += fields(pose->x, pose->y, pose->phi);
    return lineOf(payload);
  }
};

std::optional<TextMessage> helloOf(TextFields fields) {
  TextHello hello;
  fields.take(hello.version);
  fields.take(hello.watchdog_ms);
  if (!fields.allTaken() || hello.version < 0 || hello.watchdog_ms < 0) return std::nullopt;
  return hello;
}

std::optional<TextMessage> velocityOf(TextFields fields) {
  TextVelocity velocity;
  fields.take(velocity.twist.vx);
  fields.take(velocity.twist.vy);
  fields.take(velocity.twist.omega);
  if (!fields.allTaken()) return std::nullopt;
  return velocity;
}

std::optional<TextMessage> stateOf(TextFields fields) {
  TextState state;
  fields.take(state.time_ms);
  for (double* value : {&state.odometry.x, &state.odometry.y, &state.odometry.phi, &state.twist.vx,
                        &state.twist.vy, &state.twist.omega})
    fields.take(*value);
  if (fields.left()) fields.take(state.halt);
  if (fields.left()) {
    auto& pose = state.mapFromRobot.emplace();
    for (double* value : {&pose.x, &pose.y, &pose.phi}) fields.take(*value);
  }
  if (!fields.allTaken() || state.halt.size() > kLongestTextHalt) return std::nullopt;
  return state;
}

}  // namespace

std::string toTextLine(const TextMessage& message) { return std::visit(ToLine(), message); }

std::optional<TextMessage> fromTextLine(std::string_view line) {
  const auto payload = payloadOf(line);
  if (!payload || line.size() > kLongestTextLine) return std::nullopt;
  if (*payload == "X") return TextStop();
  if (payload->size() < 2 || (*payload)[1] != ',') return std::nullopt;
  const TextFields fields(payload->substr(2));
  switch (payload->front()) {
    case 'H':
      return helloOf(fields);
    case 'V':
      return velocityOf(fields);
    case 'S':
      return stateOf(fields);
    default:
      return std::nullopt;
  }
}

std::optional<std::string> TextLines::take(char byte) {
  if (byte == '\n') return std::exchange(line_, {});
  if (line_.size() <= kLongestTextLine) line_ += byte;
  return std::nullopt;
}

}  // namespace bslnav
