#pragma once

#include <bslnav/config/ConfigSection.h>

namespace bslnav {

struct SeenPeopleParameters {
  double clusterGap_m = 0.1;         ///< hits this near are of one thing
  double standingTolerance_m = 0.1;  ///< a hit this near to an obstacle that stands is of it
  double narrowest_m = 0.35, widest_m = 1.5;  ///< of what may be people
  double straight_m = 0.33;                   ///< what is straight over so much is none
  double lowest_m = 0.8;                      ///< what a depth camera sees to be lower is none
  double standing_s = 1.0;        ///< what is narrower and stands so long is an obstacle
  double personStanding_s = 3.0;  ///< a person who stands so long is Standing
  /** The middle of what is seen of a thing that stands stays within this distance and half its
   * width. */
  double stillWithin_m = 0.12;

  void describe(ConfigSection& section);
};

}  // namespace bslnav
