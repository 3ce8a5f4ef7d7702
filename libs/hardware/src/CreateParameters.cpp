#include <bslnav/hardware/CreateParameters.h>

namespace bslnav {

void CreateParameters::describe(ConfigSection& section) {
  section.text("port", port, "serial port of the robot");
  section.integer("baud", baud, kPositive, "baud", "of the serial port; the robot's default");
  section.number("wheel_base_m", wheelBase_m, kPositive, "m", "from wheel to wheel");
  section.number("wheel_diameter_m", wheelDiameter_m, kPositive, "m", "of a wheel");
  section.number("counts_per_revolution", countsPerRevolution, kPositive, "",
                 "encoder counts in one turn of a wheel");
  section.number("max_wheel_speed_mps", maxWheelSpeed_mps, {1e-3, 0.5}, "m/s",
                 "faster commands are slowed down, both wheels alike");
  section.number("command_timeout_s", commandTimeout_s, kPositive, "s",
                 "the wheels are stopped when no command came for so long");
}

}  // namespace bslnav
