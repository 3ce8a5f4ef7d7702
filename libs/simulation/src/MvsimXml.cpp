#include "MvsimXml.h"

#include <cstdio>

namespace bslnav {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\'')
      result += "&apos;";
    else
      result += c;
  }
  return result;
}

std::string number(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.6f", value);
  std::string text = buffer;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

std::string xmlNumbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + number(value);
  return text;
}

void MvsimXml::begin(const std::string& name, Attributes attributes) {
  text_ += std::string(2 * open_.size(), ' ') + '<' + name;
  for (const auto& [key, value] : attributes)
    text_ += std::string(" ") + key + "=\"" + escaped(value) + '"';
}

void MvsimXml::open(const std::string& name, Attributes attributes) {
  begin(name, attributes);
  text_ += ">\n";
  open_.push_back(name);
}

void MvsimXml::close() {
  const std::string name = open_.back();
  open_.pop_back();
  text_ += std::string(2 * open_.size(), ' ') + "</" + name + ">\n";
}

void MvsimXml::leaf(const std::string& name, const std::string& text, Attributes attributes) {
  begin(name, attributes);
  text_ += text.empty() ? "/>\n" : '>' + escaped(text) + "</" + name + ">\n";
}

void MvsimXml::comment(const std::string& text) {
  text_ += std::string(2 * open_.size(), ' ') + "<!-- " + text + " -->\n";
}

}  // namespace bslnav
