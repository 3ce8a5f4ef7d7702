#include "ScipLaser.h"

#include <algorithm>
#include <cmath>

namespace bslnav::test {
namespace {

char checkSum(std::string_view text) {
  unsigned sum = 0;
  for (const char c : text) sum += static_cast<unsigned char>(c);
  return static_cast<char>((sum & 0x3f) + 0x30);
}

std::string line(std::string_view text) { return std::string(text) + checkSum(text) + '\n'; }

std::string reply(std::string_view command, std::string_view status, std::string_view data = {}) {
  return std::string(command) + '\n' + line(status) + std::string(data) + '\n';
}

/** The check sum of such a line leaves its semicolon out. */
std::string fact(const std::string& text) { return text + ';' + checkSum(text) + '\n'; }

std::string digits(int value, std::size_t count) {
  const auto text = std::to_string(value);
  return std::string(count - std::min(count, text.size()), '0') + text;
}

}  // namespace

std::string scipNumber(std::uint32_t value, int characters) {
  std::string text(static_cast<std::size_t>(characters), '0');
  for (auto c = text.rbegin(); c != text.rend(); ++c, value >>= 6)
    *c = static_cast<char>((value & 0x3f) + 0x30);
  return text;
}

ScipLaser::ScipLaser(ScipModel model)
    : model_(std::move(model)), clockStart_ms_(model_.clockAtStart_ms) {}

std::string ScipLaser::answer(std::string_view command) {
  const auto name = command.substr(0, 2);
  if (name == "MD") return start(command);
  if (name == "PP" || name == "VV" || name == "II") return reply(command, "00", facts(name));
  if (name == "QT" || name == "RS" || name == "BM") {
    const bool wasOn = laserOn_;
    scanCommand_.clear();
    laserOn_ = name == "BM";
    if (name == "RS") clockStart_ms_ = 0, turns_ = 0;
    return reply(command, wasOn && laserOn_ ? "02" : "00");
  }
  const bool known = command == "SCIP2.0" || name == "SS" || name == "CR" || name == "HS";
  return reply(command, known ? "00" : "0E");
}

std::string ScipLaser::start(std::string_view command) {
  const auto numbers = command.substr(2, 13);
  if (command.size() < 15) return reply(command, "0C");
  if (!std::all_of(numbers.begin(), numbers.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return reply(command, "01");
  const auto number = [&](std::size_t from, std::size_t count) {
    return std::stoi(std::string(numbers.substr(from, count)));
  };
  const int first = number(0, 4), last = number(4, 4);
  if (last > model_.lastStep) return reply(command, "04");
  if (last < first || first < model_.firstStep) return reply(command, "05");
  firstStep_ = first;
  lastStep_ = last;
  skip_ = skipped_ = number(10, 1);
  left_ = number(11, 2);
  scanCommand_ = command;
  laserOn_ = true;
  return reply(command, "00");
}

std::string ScipLaser::turn(const std::vector<float>& ranges_m) {
  const auto sinceStart_ms = std::llround(1e3 * model_.period_s() * static_cast<double>(turns_++));
  if (scanCommand_.empty() || skipped_++ < skip_) return {};
  skipped_ = 0;
  const auto clock_ms = clockStart_ms_ + static_cast<std::uint32_t>(sinceStart_ms);
  std::string codes;
  for (int step = firstStep_; step <= lastStep_; ++step)
    codes += scipNumber(static_cast<std::uint32_t>(code_mm(
                            ranges_m.at(static_cast<std::size_t>(step - model_.firstStep)))),
                        3);
  auto data = line(scipNumber(clock_ms & 0xffffff, 4));
  for (std::size_t at = 0; at < codes.size(); at += 64) data += line(codes.substr(at, 64));
  if (left_ == 0) return reply(scanCommand_, "99", data);
  scanCommand_.replace(13, 2, digits(--left_, 2));  // its last numbers count down
  const auto packet = reply(scanCommand_, "99", data);
  if (left_ == 0) scanCommand_.clear();
  return packet;
}

int ScipLaser::code_mm(float range_m) const {
  const double range_mm = std::round(1e3 * static_cast<double>(range_m));
  if (!(range_mm < model_.maxRange_mm)) return model_.nothingCode;
  return range_mm < model_.minRange_mm ? model_.tooNearCode : static_cast<int>(range_mm);
}

std::string ScipLaser::facts(std::string_view about) const {
  const auto number = [](const char* key, int value) { return fact(key + std::to_string(value)); };
  const auto maker = fact("MODL:" + model_.name + "(Hokuyo Automatic Co.,Ltd.)");
  if (about == "VV")
    return fact("VEND:Hokuyo Automatic Co.,Ltd.") + fact("PROD:SOKUIKI Sensor " + model_.name) +
           fact("FIRM:3.1.00(18/Jan./2007)") + fact("PROT:SCIP 2.0") + fact("SERI:H0000000");
  if (about == "II")
    return maker + fact(laserOn_ ? "LASR:ON" : "LASR:OFF") +
           fact("SCSP:Initial(" + std::to_string(model_.speed_rpm) + "[rpm])") +
           fact("MESM:" + std::string(scanCommand_.empty() ? "IDLE" : "Measuring")) +
           fact("SBPS:USB") + fact("STAT:Sensor works well.");
  return maker + number("DMIN:", model_.minRange_mm) + number("DMAX:", model_.maxRange_mm) +
         number("ARES:", model_.stepsPerTurn) + number("AMIN:", model_.firstStep) +
         number("AMAX:", model_.lastStep) + number("AFRT:", model_.frontStep) +
         number("SCAN:", model_.speed_rpm);
}

}  // namespace bslnav::test
