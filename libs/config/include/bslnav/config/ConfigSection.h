#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace bslnav {

/** Closed interval of accepted values, in the unit that the INI key uses. */
struct Range {
  double lowest = std::numeric_limits<double>::lowest();
  double highest = std::numeric_limits<double>::max();
};
inline constexpr Range kPositive{1e-9, std::numeric_limits<double>::max()};
inline constexpr Range kNonNegative{0.0, std::numeric_limits<double>::max()};

/** One INI section: the description of its keys, bound to the variables that they set.
 *
 * A parameter struct describes itself once, in `describe(ConfigSection&)`; that one description
 * loads, checks, prints and saves it. The bound variables must outlive the section. Values that a
 * variable has when it is described are the defaults.
 */
class ConfigSection {
 public:
  struct Field {
    std::string key, unit, expected, defaultText, description;
    std::function<std::string()> write;  ///< the value as INI text
    std::function<void(const std::string&)>
        read;  ///< throws std::invalid_argument on text it cannot take
  };

  ConfigSection(std::string name, std::string description)
      : name_(std::move(name)), description_(std::move(description)) {}

  void number(const std::string& key, double& value, Range range, const std::string& unit,
              const std::string& text);
  void integer(const std::string& key, int& value, Range range, const std::string& unit,
               const std::string& text);
  /** Radians in the program, degrees in the INI; `rangeDeg` is in degrees and the key ends in
   * `_deg` or `_degps`. */
  void angle(const std::string& key, double& value_rad, Range rangeDeg, const std::string& text);
  void flag(const std::string& key, bool& value, const std::string& text);
  void text(const std::string& key, std::string& value, const std::string& text);
  /** "x y, x y, ..." in metres, at least `fewest` points. */
  void points(const std::string& key, std::vector<mrpt::math::TPoint2D>& value, std::size_t fewest,
              const std::string& text);
  /** "a, b, ...", may be empty. */
  void numbers(const std::string& key, std::vector<double>& value, Range range,
               const std::string& unit, const std::string& text);
  /** "x y heading": metres, metres, degrees. */
  void pose(const std::string& key, mrpt::math::TPose2D& value, const std::string& text);
  /** "x y heading, x y heading, ...": metres, metres, degrees; may be empty. */
  void poses(const std::string& key, std::vector<mrpt::math::TPose2D>& value,
             const std::string& text);

  /** One of a fixed set of words. */
  template <typename Enum>
  void choice(const std::string& key, Enum& value, std::vector<std::pair<std::string, Enum>> words,
              const std::string& text) {
    std::vector<std::string> names;
    names.reserve(words.size());
    for (const auto& word : words) names.push_back(word.first);
    addChoice(
        key, names, text,
        [&value, words] {
          for (std::size_t i = 0; i < words.size(); ++i)
            if (words[i].second == value) return i;
          return std::size_t{0};
        },
        [&value, words](std::size_t i) { value = words[i].second; });
  }

  const std::string& name() const { return name_; }
  const std::string& description() const { return description_; }
  const std::vector<Field>& fields() const { return fields_; }

 private:
  void add(Field field);
  void addChoice(const std::string& key, const std::vector<std::string>& names,
                 const std::string& text, std::function<std::size_t()> get,
                 std::function<void(std::size_t)> set);

  std::string name_, description_;
  std::vector<Field> fields_;
};

}  // namespace bslnav
