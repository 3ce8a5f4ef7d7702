#pragma once

#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/hardware/CreateBase.h>
#include <bslnav/hardware/RobotDrive.h>
#include <bslnav/hardware/TextBase.h>

#include <map>
#include <memory>
#include <string>

namespace bslnav {

/** The word for what moves, as in the configuration. */
const char* nameOf(RobotType type);

/** What a real robot is made of, besides what it shares with a simulated one. */
struct HardwareSetup {
  DriveParameters drive;
  SensorsParameters sensors;
  CreateParameters create;
  TextBaseParameters textBase;
  std::map<std::string, Config::FreeSection> drivers;  ///< of sensors, as in rawlog-grabber
  std::map<std::string, Config::FreeSection> plugins;  ///< at most one: a base

  /** Binds every part to its section; this object must outlive the configuration. */
  void bind(Config& config);
  /** Checks of more than one key. @throws Error */
  void check(RobotType type) const;
  /** Connects with the base. @throws Error (Run) when it does not answer */
  std::unique_ptr<Base> makeBase(RobotType type) const;
};

}  // namespace bslnav
