#include <bslnav/config/Error.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "MapImage.h"

namespace bslnav {
namespace {

/** The keys and values of ROS map_server's YAML, one `key: value` a line. */
class RosMapKeys {
 public:
  explicit RosMapKeys(const std::string& file) : file_(file) {
    std::ifstream in(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) take(line, number);
    if (values_.empty()) throw Error(file, "empty; expected the keys of a ROS map_server map");
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& expected) const {
    const auto found = values_.find(key);
    const std::string is = found == values_.end() ? "missing" : "'" + found->second + "'";
    throw Error(file_ + " " + key, is + "; expected " + expected);
  }

  std::string text(const std::string& key, const std::string& expected) const {
    const auto found = values_.find(key);
    if (found == values_.end() || found->second.empty()) refuse(key, expected);
    return found->second;
  }

  double number(const std::string& key, double lowest, double highest,
                const std::string& expected) const {
    const double value = parsed(text(key, expected), key, expected);
    if (!(value >= lowest && value <= highest)) refuse(key, expected);
    return value;
  }

  std::array<double, 3> pose(const std::string& key) const {
    const std::string expected = "[x, y, yaw] in metres and radians";
    const std::string list = text(key, expected);
    if (list.front() != '[' || list.back() != ']') refuse(key, expected);
    std::array<double, 3> result{};
    std::istringstream in(list.substr(1, list.size() - 2));
    std::string word;
    std::size_t n = 0;
    for (; std::getline(in, word, ','); ++n) {
      if (n == result.size()) refuse(key, expected);
      result[n] = parsed(trimmed(word), key, expected);
    }
    if (n != result.size()) refuse(key, expected);
    return result;
  }

  bool has(const std::string& key) const { return values_.count(key) > 0; }

 private:
  static std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  }

  double parsed(const std::string& word, const std::string& key,
                const std::string& expected) const {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value)) refuse(key, expected);
    return value;
  }

  void take(const std::string& line, int number) {
    const std::string content = trimmed(line.substr(0, line.find('#')));
    if (content.empty() || content == "---") return;
    const std::string where = file_ + " line " + std::to_string(number);
    const auto colon = content.find(':');
    if (colon == std::string::npos) throw Error(where, "'" + content + "'; expected 'key: value'");
    const std::string key = trimmed(content.substr(0, colon));
    std::string value = trimmed(content.substr(colon + 1));
    if (value.size() >= 2 && (value.front() == '"' || value.front() == '\'') &&
        value.back() == value.front())
      value = value.substr(1, value.size() - 2);
    for (const char* known :
         {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"})
      if (key == known) {
        if (!values_.emplace(key, value).second) throw Error(where + " " + key, "given twice");
        return;
      }
    throw Error(where + " " + key,
                "unknown key; expected image, resolution, origin, negate, occupied_thresh, "
                "free_thresh or mode");
  }

  std::string file_;
  std::map<std::string, std::string> values_;
};

}  // namespace

std::shared_ptr<mrpt::maps::COccupancyGridMap2D> loadRosMap(const std::string& file) {
  const RosMapKeys keys(file);
  ImageInterpretation meaning;
  meaning.trinary = true;
  meaning.resolution_m = keys.number("resolution", 1e-3, 1e3, "metres a pixel, 0.001 to 1000");
  const auto origin = keys.pose("origin");
  if (origin[2] != 0.0) keys.refuse("origin", "a yaw of 0: grids are aligned with the map frame");
  meaning.origin = {origin[0], origin[1]};
  const std::string negate = keys.text("negate", "0 or 1");
  if (negate != "0" && negate != "1" && negate != "true" && negate != "false")
    keys.refuse("negate", "0 or 1");
  meaning.negate = negate == "1" || negate == "true";
  meaning.occupiedThreshold = keys.number("occupied_thresh", 0.0, 1.0, "a probability");
  meaning.freeThreshold = keys.number("free_thresh", 0.0, 1.0, "a probability");
  if (meaning.freeThreshold >= meaning.occupiedThreshold)
    keys.refuse("free_thresh", "a value below occupied_thresh");
  if (keys.has("mode") && keys.text("mode", "trinary") != "trinary") keys.refuse("mode", "trinary");
  const std::filesystem::path image = keys.text("image", "the image's file name");
  return loadMapImage((std::filesystem::path(file).parent_path() / image).string(),
                      meaning);  // an absolute image path wins
}

}  // namespace bslnav
