#include <bslnav/blindspot/HiddenPeople.h>

namespace bslnav {

void HiddenPeopleParameters::describe(ConfigSection& section) {
  section.number("person_radius_m", radius_m, {0.05, 1.0}, "m",
                 "radius of the smallest disc that a person covers: nobody hides where it does not "
                 "fit, nor in that of somebody who is seen");
  section.number("gap_m", gap_m, {0.0, 2.0}, "m",
                 "nobody comes out between two neighbouring hits nearer to each other");
  section.number("map_tolerance_m", mapTolerance_m, kNonNegative, "m",
                 "a hit this near to an occupied cell of the map is the map's");
  section.number("reach_m", reach_m, {1.0, 20.0}, "m",
                 "how far from the robot hidden people matter, to each side");
  section.number("resolution_m", resolution_m, {0.01, 0.5}, "m", "side of a cell");
  section.number("look_memory_s", lookMemory_s, kNonNegative, "s",
                 "a direction counts as looked at for so long");
  section.choice("outside_view", outsideView,
                 {{"free", OutsideView::Free}, {"remembered", OutsideView::Remembered}},
                 "who comes from where no sensor looks: nobody, or whoever can have got there "
                 "since it was seen empty");
}

}  // namespace bslnav
