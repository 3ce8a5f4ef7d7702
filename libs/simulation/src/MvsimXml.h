#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace bslnav {

/** Writes an XML document, indented, its text and attributes escaped. */
class MvsimXml {
 public:
  using Attributes = std::initializer_list<std::pair<const char*, std::string>>;

  /** Begins an element that others stand in. */
  void open(const std::string& name, Attributes attributes = {});
  /** Ends the element that was begun last. */
  void close();
  /** An element with text alone; without text `<name .../>`. */
  void leaf(const std::string& name, const std::string& text = "", Attributes attributes = {});
  void comment(const std::string& text);

  const std::string& text() const { return text_; }

 private:
  void begin(const std::string& name, Attributes attributes);

  std::string text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  std::vector<std::string> open_;
};

/** Numbers [m, degrees, ...] to six decimals without idle zeros, separated by spaces. */
std::string xmlNumbers(std::initializer_list<double> values);

}  // namespace bslnav
