#pragma once

#include <bslnav/config/ConfigSection.h>

#include <string>

namespace bslnav {

/** Which engine chooses velocities. */
enum class NavigatorType : std::uint8_t { Dwa, Ptg, Mrpt };

struct NavigatorParameters {
  NavigatorType type = NavigatorType::Dwa;
  std::string mrptConfig = "config/mrpt/reactive.ini";
  std::string mrptMethod = "CHolonomicFullEval";

  void describe(ConfigSection& section);
};

}  // namespace bslnav
