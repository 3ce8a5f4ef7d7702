#include <bslnav/config/Config.h>
#include <bslnav/simulation/WorldParameters.h>

namespace bslnav {
namespace {

using Points = std::vector<mrpt::math::TPoint2D>;

constexpr double kShortest_m = 1e-6;

void describeHeights(ConfigSection& section, double& zMin_m, double& zMax_m, bool& mapped) {
  section.number("z_min_m", zMin_m, kNonNegative, "m", "height of the lower face above the floor");
  section.number("z_max_m", zMax_m, kPositive, "m", "height of the upper face above the floor");
  section.flag("mapped", mapped, "whether the static map shows it");
}

void requirePositive(const std::string& section, const std::string& key, double value) {
  if (!(value > 0.0)) Config::refuse(section, key, "a number above 0");
}

void requireHeights(const std::string& section, double zMin_m, double zMax_m) {
  if (!(zMin_m >= 0.0)) Config::refuse(section, "z_min_m", "a number of at least 0");
  if (!(zMax_m > zMin_m)) Config::refuse(section, "z_max_m", "a height above z_min_m");
}

void requirePolyline(const std::string& section, const std::string& key, const Points& points) {
  if (points.size() < 2) Config::refuse(section, key, "at least two points");
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!((points[i] - points[i - 1]).norm() > kShortest_m))
      Config::refuse(section, key, "neighbouring points that differ (no segment of length 0)");
}

void check(const std::string& section, const PedestrianParameters& person) {
  requirePolyline(section, "path_m", person.path_m);
  requirePositive(section, "speed_mps", person.speed_mps);
  requirePositive(section, "radius_m", person.radius_m);
  requirePositive(section, "height_m", person.height_m);
  const auto requireNonNegative = [&section](const std::string& key, double value) {
    if (!(value >= 0.0)) Config::refuse(section, key, "a number of at least 0");
  };
  requireNonNegative("start_delay_s", person.startDelay_s);
  requireNonNegative("pause_after_m", person.pauseAfter_m);
  requireNonNegative("pause_s", person.pause_s);
  requireNonNegative("yields_within_m", person.yieldsWithin_m);
  requireNonNegative("walks_round_after_s", person.walksRoundAfter_s);
  if (person.walksRoundAfter_s > 0.0 && person.yieldsWithin_m == 0.0)
    Config::refuse(section, "walks_round_after_s", "0, or yields_within_m above 0 as well");
  if (person.triggerLine_m.empty()) return;
  if (person.triggerLine_m.size() != 2)
    Config::refuse(section, "trigger_line_m", "two points, or none to start at once");
  requirePolyline(section, "trigger_line_m", person.triggerLine_m);
}

}  // namespace

void WallParameters::describe(ConfigSection& section) {
  section.points("points_m", points_m, 2, "middle line of the wall in the map");
  section.number("thickness_m", thickness_m, kPositive, "m", "thickness of the wall");
  describeHeights(section, zMin_m, zMax_m, mapped);
}

void BoxParameters::describe(ConfigSection& section) {
  section.pose("pose", pose, "centre and heading in the map");
  section.number("length_m", length_m, kPositive, "m", "size along the heading");
  section.number("width_m", width_m, kPositive, "m", "size across the heading");
  describeHeights(section, zMin_m, zMax_m, mapped);
}

void CylinderParameters::describe(ConfigSection& section) {
  section.number("x_m", x_m, {}, "m", "centre in the map");
  section.number("y_m", y_m, {}, "m", "centre in the map");
  section.number("radius_m", radius_m, kPositive, "m", "radius");
  describeHeights(section, zMin_m, zMax_m, mapped);
}

void PedestrianParameters::describe(ConfigSection& section) {
  section.points("path_m", path_m, 2, "where the person walks, from the first point to the last");
  section.number("speed_mps", speed_mps, kPositive, "m/s", "walking speed");
  section.number("radius_m", radius_m, kPositive, "m", "radius of the person seen from above");
  section.number("height_m", height_m, kPositive, "m", "height of the person");
  section.points("trigger_line_m", triggerLine_m, 0,
                 "two points: the person starts when the robot's centre crosses the segment "
                 "between them; empty: at once");
  section.number("start_delay_s", startDelay_s, kNonNegative, "s",
                 "time from the trigger to the first step");
  section.number("pause_after_m", pauseAfter_m, kNonNegative, "m",
                 "after so much of the path the person stands for pause_s");
  section.number("pause_s", pause_s, kNonNegative, "s", "how long; 0: no pause");
  section.number("yields_within_m", yieldsWithin_m, kNonNegative, "m",
                 "the person waits while the next step would lead nearer to the robot's centre and "
                 "into this distance; 0: does not see the robot");
  section.number("walks_round_after_s", walksRoundAfter_s, kNonNegative, "s",
                 "who has waited so long for the robot walks round it at yields_within_m, where "
                 "there is room; 0: waits on");
}

void WorldParameters::check() const {
  for (const auto& [name, wall] : walls) {
    requirePolyline("wall:" + name, "points_m", wall.points_m);
    requirePositive("wall:" + name, "thickness_m", wall.thickness_m);
    requireHeights("wall:" + name, wall.zMin_m, wall.zMax_m);
  }
  for (const auto& [name, box] : boxes) {
    requirePositive("box:" + name, "length_m", box.length_m);
    requirePositive("box:" + name, "width_m", box.width_m);
    requireHeights("box:" + name, box.zMin_m, box.zMax_m);
  }
  for (const auto& [name, cylinder] : cylinders) {
    requirePositive("cylinder:" + name, "radius_m", cylinder.radius_m);
    requireHeights("cylinder:" + name, cylinder.zMin_m, cylinder.zMax_m);
  }
  for (const auto& [name, person] : pedestrians) bslnav::check("pedestrian:" + name, person);
}

}  // namespace bslnav
