#include "IniLines.h"

#include <bslnav/config/Error.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>

namespace bslnav {
namespace {

/** Without white space at both ends, in lower case: MRPT does not tell `Key` from `key`. */
std::string word(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  std::string result = text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/** The next line, with those it goes on with after a backslash; counts them. */
bool nextLine(std::istream& in, std::string& line, int& number) {
  if (!std::getline(in, line)) return false;
  ++number;
  for (std::string more; !line.empty() && line.back() == '\\' && std::getline(in, more); ++number) {
    line.pop_back();
    line += more;
  }
  return true;
}

}  // namespace

void checkIniLines(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(file, "cannot be read; expected a configuration (INI)");
  std::set<std::string> keys;
  std::string line, section;
  for (int number = 0, first = 1; nextLine(in, line, number); first = number + 1) {
    const std::string where = file + ":" + std::to_string(first);
    const std::string text = word(line);
    if (text.find('\0') != std::string::npos)
      throw Error(where, "binary data; expected a text file (INI)");
    if (text.empty() || text[0] == ';' || text[0] == '#' || text.rfind("@define", 0) == 0) continue;
    const auto equals = text.find('=');
    if (text[0] == '[') {
      if (text.back() != ']' || text.find(']') + 1 != text.size())
        throw Error(where, "malformed section; expected [name] and nothing else");
      section = word(text.substr(1, text.size() - 2));
      if (section.empty()) throw Error(where, "a section without a name; expected [name]");
    } else if (equals == std::string::npos || word(text.substr(0, equals)).empty()) {
      throw Error(where, "expected key = value, [section], a comment or @define");
    } else if (section.empty()) {
      throw Error(where, "a key before any section; expected [section] first");
    } else if (const std::string key = word(text.substr(0, equals));
               !keys.insert(section + "]" + key).second) {
      throw Error(where + " [" + section + "] " + key, "given twice; expected one value");
    }
  }
}

}  // namespace bslnav
