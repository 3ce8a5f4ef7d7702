#pragma once

#include <bslnav/config/ConfigSection.h>

#include <string>

namespace bslnav {

/** Which engine chooses velocities. */
enum class NavigatorType : std::uint8_t { Dwa, Ptg, Mrpt };

struct NavigatorParameters {
  NavigatorType type = NavigatorType::Dwa;
  std::string ptgConfig = "config/mrpt/reactive.ini";
  std::string mrptConfig = "/usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini";
  std::string mrptMethod = "CHolonomicFullEval";

  /** MRPT's INI file for this type. */
  const std::string& config() const { return type == NavigatorType::Ptg ? ptgConfig : mrptConfig; }
  void describe(ConfigSection& section);
};

}  // namespace bslnav
