#include <bslnav/hardware/TextProtocol.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace bslnav {
namespace {

/** A number of ten-thousandths: what a line can hold exactly. */
double anyDecimal() { return *rc::gen::resize(100, rc::gen::arbitrary<int>()) * 1e-4; }

mrpt::math::TPose2D anyPose() { return {anyDecimal(), anyDecimal(), anyDecimal()}; }

mrpt::math::TTwist2D anyTwist() { return {anyDecimal(), anyDecimal(), anyDecimal()}; }

std::string anyHalt() {
  const auto letter = rc::gen::oneOf(rc::gen::inRange('a', '{'), rc::gen::just(' '));
  auto halt = *rc::gen::container<std::string>(letter);
  halt.resize(std::min(halt.size(), kLongestTextHalt));
  return halt;
}

TextMessage anyMessage() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return TextHello{*rc::gen::inRange(0, 100), *rc::gen::inRange(0, 10000)};
    case 1:
      return TextVelocity{anyTwist()};
    case 2:
      return TextStop();
    default:
      TextState state{*rc::gen::arbitrary<std::uint32_t>(), anyPose(), anyTwist(), anyHalt(), {}};
      if (*rc::gen::arbitrary<bool>()) state.mapFromRobot = anyPose();
      return state;
  }
}

std::vector<TextMessage> messagesIn(const std::string& bytes) {
  TextLines lines;
  std::vector<TextMessage> messages;
  for (const char byte : bytes)
    if (const auto line = lines.take(byte))
      if (const auto message = fromTextLine(*line)) messages.push_back(*message);
  return messages;
}

bool near(const mrpt::math::TPose2D& a, const mrpt::math::TPose2D& b) {
  return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.phi - b.phi) < 1e-6;
}

bool near(const mrpt::math::TTwist2D& a, const mrpt::math::TTwist2D& b) {
  return std::abs(a.vx - b.vx) + std::abs(a.vy - b.vy) + std::abs(a.omega - b.omega) < 1e-6;
}

struct Same {
  bool operator()(const TextHello& a, const TextHello& b) const {
    return a.version == b.version && a.watchdog_ms == b.watchdog_ms;
  }
  bool operator()(const TextVelocity& a, const TextVelocity& b) const {
    return near(a.twist, b.twist);
  }
  bool operator()(const TextStop&, const TextStop&) const { return true; }
  bool operator()(const TextState& a, const TextState& b) const {
    return a.time_ms == b.time_ms && near(a.odometry, b.odometry) && near(a.twist, b.twist) &&
           a.halt == b.halt && a.mapFromRobot.has_value() == b.mapFromRobot.has_value() &&
           (!a.mapFromRobot || near(*a.mapFromRobot, *b.mapFromRobot));
  }
  template <typename A, typename B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

RC_GTEST_PROP(TextProtocolLaw, WhatIsWrittenIsReadAndWrittenTheSame, ()) {
  const TextMessage message = anyMessage();
  const std::string line = toTextLine(message);
  RC_ASSERT(line.size() <= kLongestTextLine + 1);
  const auto read = messagesIn(line);
  RC_ASSERT(read.size() == 1U);
  RC_ASSERT(std::visit(Same(), read.front(), message));
  RC_ASSERT(toTextLine(read.front()) == line);
}

// All bytes of a line, its line feed too, in place of which each of the 255 others.
RC_GTEST_PROP(TextProtocolLaw, NoByteOfALineCanBeAnother, ()) {
  const std::string line = toTextLine(anyMessage());
  const auto place = *rc::gen::inRange<std::size_t>(0, line.size());
  for (int other = 1; other < 256; ++other) {
    std::string damaged = line;
    damaged[place] = static_cast<char>(damaged[place] ^ other);
    RC_ASSERT(messagesIn(damaged).empty());
    const auto next = messagesIn(damaged + "$X*58\n");  // at worst the line feed's loss costs it
    RC_ASSERT(next.size() == (place + 1 < line.size() ? 1U : next.size()));
    RC_ASSERT(next.empty() || std::holds_alternative<TextStop>(next.front()));
  }
}

RC_GTEST_PROP(TextProtocolLaw, PartOfALineIsNothing, ()) {
  const std::string line = toTextLine(anyMessage());
  const auto length = *rc::gen::inRange<std::size_t>(0, line.size() - 1);
  RC_ASSERT(messagesIn(line.substr(0, length) + '\n').empty());
  RC_ASSERT(messagesIn(line.substr(line.size() - 1 - length)).empty());
}

RC_GTEST_PROP(TextProtocolLaw, GarbageHarmsNothing, ()) {
  const auto garbage = *rc::gen::arbitrary<std::string>();
  const auto messages = messagesIn(garbage + "\n$X*58\n");
  RC_ASSERT(messages.size() == 1U);
}

}  // namespace
}  // namespace bslnav
