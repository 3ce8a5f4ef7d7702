#include "TextFields.h"

#include <algorithm>
#include <array>
#include <limits>

namespace bslnav {

std::string checkSum(std::string_view payload) {
  unsigned char sum = 0;
  for (const char c : payload)
    sum = static_cast<unsigned char>(sum ^ static_cast<unsigned char>(c));
  constexpr char kDigits[] = "0123456789ABCDEF";
  return {kDigits[sum >> 4], kDigits[sum & 15]};
}

std::optional<std::string_view> payloadOf(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.size() < 5 || line.front() != '$' || line[line.size() - 3] != '*') return std::nullopt;
  const auto payload = line.substr(1, line.size() - 4);
  if (!std::all_of(payload.begin(), payload.end(), isPayload)) return std::nullopt;
  if (checkSum(payload) != line.substr(line.size() - 2)) return std::nullopt;
  return payload;
}

std::string decimal(double value) {
  std::array<char, std::numeric_limits<double>::max_exponent10 + 8>
      text{};  // sign, point, decimals
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 4).ptr;
  return {text.data(), end};
}

std::string_view TextFields::next(std::string_view characters) {
  if (!rest_) {
    good_ = false;
    return {};
  }
  const auto comma = rest_->find(',');
  const auto field = rest_->substr(0, comma);
  if (comma == std::string_view::npos)
    rest_.reset();
  else
    rest_->remove_prefix(comma + 1);
  if (!characters.empty() && field.find_first_not_of(characters) != std::string_view::npos)
    good_ = false;
  return field;
}

void TextFields::take(std::string& value) { value = next(); }

void TextFields::take(double& value) { convert(next("-.0123456789"), value); }

}  // namespace bslnav
