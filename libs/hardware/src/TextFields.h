#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace bslnav {

/** Whether a character may stand between a line's `$` and its `*`. */
inline bool isPayload(char c) { return c >= ' ' && c <= '~' && c != '$' && c != '*'; }

/** The exclusive or of all bytes, as two upper-case hexadecimal digits. */
std::string checkSum(std::string_view payload);

/** What stands between `$` and `*` of a line, when its check sum is right. */
std::optional<std::string_view> payloadOf(std::string_view line);

/** With four decimals and a point, whatever the locale. */
std::string decimal(double value);

/** Takes field after field from a payload. Once one is missing or not what it should be, nothing
 * more is taken and `allTaken()` stays false. */
class TextFields {
 public:
  explicit TextFields(std::string_view payload) : rest_(payload) {}

  void take(std::string& value);
  /** Digits, a point and a minus sign only: from_chars alone would take "nan" and "1e9", too. */
  void take(double& value);
  template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
  void take(Integer& value) {
    convert(next("-0123456789"), value);
  }

  bool left() const { return rest_.has_value(); }
  bool allTaken() const { return !left() && good_; }

 private:
  std::string_view next(std::string_view characters = {});

  template <typename Number>
  void convert(std::string_view text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) good_ = false;
  }

  std::optional<std::string_view> rest_;
  bool good_ = true;
};

}  // namespace bslnav
