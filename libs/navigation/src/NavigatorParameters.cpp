#include <bslnav/navigation/NavigatorParameters.h>

namespace bslnav {

void NavigatorParameters::describe(ConfigSection& section) {
  section.choice(
      "type", type,
      {{"dwa", NavigatorType::Dwa}, {"ptg", NavigatorType::Ptg}, {"mrpt", NavigatorType::Mrpt}},
      "dwa: dynamic window of velocities; ptg: MRPT's PTG-based navigation with our "
      "cost function; mrpt: the same as MRPT ships it, for comparison");
  section.text(
      "ptg_config", ptgConfig,
      "MRPT's INI file with the PTGs for ptg; speeds, robot shape and holonomic method are "
      "set from here");
  section.text("mrpt_config", mrptConfig, "the same for mrpt; the default is MRPT's own example");
  section.text("mrpt_method", mrptMethod,
               "holonomic method of mrpt: CHolonomicFullEval, CHolonomicND or CHolonomicVFF");
}

}  // namespace bslnav
