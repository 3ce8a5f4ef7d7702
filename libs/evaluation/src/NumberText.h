#pragma once

#include <cstdio>
#include <string>

namespace bslnav {

/** A number by a printf format for one double. */
inline std::string numberText(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace bslnav
