#include "HardwareSetup.h"

#include <bslnav/hardware/BasePlugin.h>

namespace bslnav {

const char* nameOf(RobotType type) {
  static constexpr const char* kNames[] = {"simulated", "create", "text", "plugin"};
  return kNames[static_cast<int>(type)];
}

void HardwareSetup::bind(Config& config) {
  config.bind("drive", "What stops a real robot.", drive);
  config.bind("sensors", "All sensors of a real robot; each has a section of its own besides.",
              sensors);
  config.bind("create", "An iRobot Create 2 or Roomba, when [robot] type is create.", create);
  config.bind("text_base", "A base that speaks bslnav's text protocol, when [robot] type is text.",
              textBase);
  config.bindFree("driver", "A sensor: a section as MRPT's rawlog-grabber has it.", drivers);
  config.bindFree("library", "A base from a shared library, when [robot] type is plugin.", plugins);
}

void HardwareSetup::check(RobotType type) const {
  if (type == RobotType::Simulated) return;
  if (drivers.empty())
    Config::refuse("NAME", "driver", "a section with the driver of a sensor, such as CHokuyoURG");
  if (type == RobotType::Plugin && plugins.size() != 1)
    Config::refuse("NAME", "library", "one section that names the shared library of the base");
}

std::unique_ptr<Base> HardwareSetup::makeBase(RobotType type) const {
  switch (type) {
    case RobotType::Create:
      return std::make_unique<CreateBase>(create);
    case RobotType::Text:
      return std::make_unique<TextBase>(textBase);
    case RobotType::Plugin: {
      const auto& options = plugins.begin()->second;
      return loadBase(dataFile(options.at("library")), options);
    }
    case RobotType::Simulated:
      break;
  }
  throw Error("configuration [robot] type", "a simulated robot has no hardware");
}

}  // namespace bslnav
