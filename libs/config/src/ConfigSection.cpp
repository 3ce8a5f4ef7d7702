#include <bslnav/config/ConfigSection.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace bslnav {
namespace {

constexpr double kDegreesPerRadian = 180.0 / M_PI;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/** The shortest text that reads back as the same number. */
std::string format(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

double parse(const std::string& text) {
  const std::string word = trimmed(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size())
    throw std::invalid_argument("not a number");
  if (!std::isfinite(value)) throw std::invalid_argument("not finite");
  return value;
}

/** Degrees of a value kept in radians: twelve digits hide the rounding of the conversion, where
 * they read back as the same number; else as many as it takes. */
std::string formatDegrees(double value_rad) {
  char buffer[32];
  const double degrees = value_rad * kDegreesPerRadian;
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, degrees, std::chars_format::general, 12).ptr;
  const std::string rounded(buffer, end);
  if (parse(rounded) / kDegreesPerRadian == value_rad) return rounded;
  for (const double nearby :
       {degrees, std::nextafter(degrees, HUGE_VAL), std::nextafter(degrees, -HUGE_VAL)})
    if (nearby / kDegreesPerRadian == value_rad) return format(nearby);
  return format(degrees);
}

double checked(double value, Range range) {
  if (value < range.lowest || value > range.highest) throw std::invalid_argument("out of range");
  return value;
}

std::string expectedNumber(const std::string& kind, Range range) {
  const bool below = range.lowest > std::numeric_limits<double>::lowest();
  const bool above = range.highest < std::numeric_limits<double>::max();
  if (below && above)
    return kind + " from " + format(range.lowest) + " to " + format(range.highest);
  if (below)
    return kind + (range.lowest == 1e-9 ? " above 0" : " of at least " + format(range.lowest));
  if (above) return kind + " of at most " + format(range.highest);
  return kind;
}

/** Rows of `columns` numbers separated by commas. */
std::vector<std::vector<double>> parseRows(const std::string& text, std::size_t columns) {
  std::vector<std::vector<double>> rows;
  if (trimmed(text).empty()) return rows;
  if (trimmed(text).back() == ',') throw std::invalid_argument("cut off after a comma");
  std::stringstream stream(text);
  for (std::string row; std::getline(stream, row, ',');) {
    std::vector<double> numbers;
    std::stringstream words(row);
    for (std::string word; words >> word;) numbers.push_back(parse(word));
    if (numbers.size() != columns) throw std::invalid_argument("wrong count of numbers");
    rows.push_back(std::move(numbers));
  }
  return rows;
}

std::string formatPose(const mrpt::math::TPose2D& pose) {
  return format(pose.x) + " " + format(pose.y) + " " + formatDegrees(pose.phi);
}

mrpt::math::TPose2D toPose(const std::vector<double>& row) {
  return {row[0], row[1], row[2] / kDegreesPerRadian};
}

template <typename Items, typename Format>
std::string joined(const Items& items, Format formatItem, const std::string& separator = ", ") {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : separator) + formatItem(item);
  return text;
}

}  // namespace

void ConfigSection::add(Field field) {
  field.defaultText = field.write();
  fields_.push_back(std::move(field));
}

void ConfigSection::number(const std::string& key, double& value, Range range,
                           const std::string& unit, const std::string& text) {
  add({key,
       unit,
       expectedNumber("a number", range),
       {},
       text,
       [&value] { return format(value); },
       [&value, range](const std::string& word) { value = checked(parse(word), range); }});
}

void ConfigSection::integer(const std::string& key, int& value, Range range,
                            const std::string& unit, const std::string& text) {
  add({key,
       unit,
       expectedNumber("a whole number", range),
       {},
       text,
       [&value] { return std::to_string(value); },
       [&value, range](const std::string& word) {
         const double parsed = checked(parse(word), range);  // $eval{} writes 3 as 3.000000e+00
         if (parsed != std::trunc(parsed)) throw std::invalid_argument("not a whole number");
         if (std::abs(parsed) > std::numeric_limits<int>::max())
           throw std::invalid_argument("out of range");
         value = static_cast<int>(parsed);
       }});
}

void ConfigSection::angle(const std::string& key, double& value_rad, Range rangeDeg,
                          const std::string& text) {
  const bool isRate = key.size() > 6 && key.compare(key.size() - 6, 6, "_degps") == 0;
  add({key,
       isRate ? "deg/s" : "deg",
       expectedNumber("a number", rangeDeg),
       {},
       text,
       [&value_rad] { return formatDegrees(value_rad); },
       [&value_rad, rangeDeg](const std::string& word) {
         value_rad = checked(parse(word), rangeDeg) / kDegreesPerRadian;
       }});
}

void ConfigSection::flag(const std::string& key, bool& value, const std::string& text) {
  addChoice(
      key, {"false", "true"}, text, [&value] { return std::size_t{value}; },
      [&value](std::size_t i) { value = i == 1; });
}

void ConfigSection::text(const std::string& key, std::string& value, const std::string& text) {
  add({key,
       "",
       "text",
       {},
       text,
       [&value] { return value; },
       [&value](const std::string& word) { value = trimmed(word); }});
}

void ConfigSection::points(const std::string& key, std::vector<mrpt::math::TPoint2D>& value,
                           std::size_t fewest, const std::string& text) {
  const auto formatPoint = [](const mrpt::math::TPoint2D& p) {
    return format(p.x) + " " + format(p.y);
  };
  add({key,
       "m",
       "points \"x y, x y, ...\", at least " + std::to_string(fewest),
       {},
       text,
       [&value, formatPoint] { return joined(value, formatPoint); },
       [&value, fewest](const std::string& word) {
         const auto rows = parseRows(word, 2);
         if (rows.size() < fewest) throw std::invalid_argument("too few points");
         value.clear();
         for (const auto& row : rows) value.emplace_back(row[0], row[1]);
       }});
}

void ConfigSection::numbers(const std::string& key, std::vector<double>& value, Range range,
                            const std::string& unit, const std::string& text) {
  add({key,
       unit,
       "numbers \"a, b, ...\", each " + expectedNumber("a number", range),
       {},
       text,
       [&value] { return joined(value, format); },
       [&value, range](const std::string& word) {
         const auto rows = parseRows(word, 1);
         for (const auto& row : rows) checked(row[0], range);
         value.clear();
         for (const auto& row : rows) value.push_back(row[0]);
       }});
}

void ConfigSection::pose(const std::string& key, mrpt::math::TPose2D& value,
                         const std::string& text) {
  add({key,
       "m m deg",
       "a pose \"x y heading\"",
       {},
       text,
       [&value] { return formatPose(value); },
       [&value](const std::string& word) {
         const auto rows = parseRows(word, 3);
         if (rows.size() != 1) throw std::invalid_argument("not one pose");
         value = toPose(rows[0]);
       }});
}

void ConfigSection::poses(const std::string& key, std::vector<mrpt::math::TPose2D>& value,
                          const std::string& text) {
  add({key,
       "m m deg",
       "poses \"x y heading, x y heading, ...\"",
       {},
       text,
       [&value] { return joined(value, formatPose); },
       [&value](const std::string& word) {
         const auto rows = parseRows(word, 3);
         value.clear();
         for (const auto& row : rows) value.push_back(toPose(row));
       }});
}

void ConfigSection::addChoice(const std::string& key, const std::vector<std::string>& names,
                              const std::string& text, std::function<std::size_t()> get,
                              std::function<void(std::size_t)> set) {
  const std::string expected =
      "one of " + joined(
                      names, [](const std::string& n) { return n; }, " | ");
  add({key,
       "",
       expected,
       {},
       text,
       [names, get = std::move(get)] { return names[get()]; },
       [names, set = std::move(set)](const std::string& word) {
         const auto found = std::find(names.begin(), names.end(), trimmed(word));
         if (found == names.end()) throw std::invalid_argument("unknown word");
         set(static_cast<std::size_t>(found - names.begin()));
       }});
}

}  // namespace bslnav
