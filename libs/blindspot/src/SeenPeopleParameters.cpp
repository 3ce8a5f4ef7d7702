#include <bslnav/blindspot/SeenPeopleParameters.h>

namespace bslnav {

void SeenPeopleParameters::describe(ConfigSection& section) {
  section.number("cluster_gap_m", clusterGap_m, kPositive, "m", "hits this near are of one thing");
  section.number("standing_tolerance_m", standingTolerance_m, kNonNegative, "m",
                 "a hit this near to an obstacle that was seen to stand is of it");
  section.number("narrowest_m", narrowest_m, kNonNegative, "m",
                 "what is narrower and stands still is an obstacle, not a person");
  section.number("widest_m", widest_m, kPositive, "m",
                 "what is wider is an obstacle, not people side by side");
  section.number("straight_m", straight_m, kPositive, "m",
                 "what is straight over so much is an obstacle, not a person");
  section.number("lowest_m", lowest_m, kNonNegative, "m",
                 "what a depth camera sees whole and lower is an obstacle, not a person");
  section.number("standing_s", standing_s, kNonNegative, "s",
                 "so long has what is narrower than a person to stand still");
  section.number("person_standing_s", personStanding_s, kNonNegative, "s",
                 "past somebody who has stood so long, the robot may creep");
  section.number("still_within_m", stillWithin_m, kPositive, "m",
                 "the middle of what stands still stays within this distance and half its width");
}

}  // namespace bslnav
