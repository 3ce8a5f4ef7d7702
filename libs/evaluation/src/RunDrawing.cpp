#include <bslnav/evaluation/PictureStyles.h>
#include <bslnav/evaluation/RunDrawing.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>

#include "NumberText.h"

namespace bslnav {
namespace {

/** Everything that stands still, and the lines that make people start. */
void drawWorld(MapPicture& picture, const SimulationSetup& setup,
               const mrpt::maps::COccupancyGridMap2D* map) {
  if (map) picture.occupancy(*map);
  for (const auto& [name, c] : setup.world.cylinders)
    if (!c.mapped || !map)
      picture.disc({c.x_m, c.y_m}, c.radius_m, style::kUnmapped, "pole, not in the map");
  for (const auto& [name, b] : setup.world.boxes)
    if (!b.mapped || !map) {
      const double x = 0.5 * b.length_m, y = 0.5 * b.width_m;
      picture.polygon({b.pose.composePoint({x, y}), b.pose.composePoint({-x, y}),
                       b.pose.composePoint({-x, -y}), b.pose.composePoint({x, -y})},
                      style::kUnmapped, "box, not in the map");
    }
  for (const auto& [name, person] : setup.world.pedestrians)
    if (person.triggerLine_m.size() == 2)
      picture.segment(person.triggerLine_m[0], person.triggerLine_m[1], style::kTrigger,
                      "person starts");
}

}  // namespace

std::string outcomeLine(const RunSummary& s) {
  std::string text = nameOf(s.outcome);
  if (s.timeToGoal_s)
    text += numberText(" after %.1f s", *s.timeToGoal_s);
  else
    text += numberText(" at %.1f s", s.duration_s);
  if (s.impactSpeed_mps) text += numberText(", robot at %.2f m/s", *s.impactSpeed_mps);
  if (s.minClearance_m)
    text += numberText(", nearest person %.2f m", std::max(0.0, *s.minClearance_m));
  return text;
}

MapBounds boundsOf(const SimulationSetup& setup, const mrpt::maps::COccupancyGridMap2D* map) {
  if (map) return {map->getXMin(), map->getYMin(), map->getXMax(), map->getYMax()};
  constexpr double kMargin_m = 3.0;
  const auto& start = setup.scenario.start;
  MapBounds bounds{start.x, start.y, start.x, start.y};
  for (const auto& goal : setup.scenario.goals)
    bounds = {std::min(bounds.xMin_m, goal.x), std::min(bounds.yMin_m, goal.y),
              std::max(bounds.xMax_m, goal.x), std::max(bounds.yMax_m, goal.y)};
  return {bounds.xMin_m - kMargin_m, bounds.yMin_m - kMargin_m, bounds.xMax_m + kMargin_m,
          bounds.yMax_m + kMargin_m};
}

void drawRun(MapPicture& picture, const SimulationSetup& setup,
             const mrpt::maps::COccupancyGridMap2D* map, const RunTrace& trace,
             const RunSummary& summary) {
  drawWorld(picture, setup, map);
  picture.polyline(trace.firstPath, style::kGlobalPath, "global path at the start");
  for (std::size_t i = 0; i < trace.walks.size(); ++i) {
    picture.polyline(trace.walks[i], style::kWalk, "person's walk");
    picture.disc(trace.lastPeople[i].position, trace.lastPeople[i].radius_m, style::kPerson,
                 "person at the end");
  }
  picture.trajectory(trace.positions, trace.speed_mps, setup.navigation.limits.maxSpeed_mps,
                     "driven path");
  picture.outline(trace.lastPose, setup.navigation.footprint, style::kRobot, "robot at the end");
  const auto& start = setup.scenario.start;
  picture.marker(MarkerKind::Start, {start.x, start.y}, "start");
  for (const auto& goal : setup.scenario.goals)
    picture.marker(MarkerKind::Goal, {goal.x, goal.y},
                   &goal == &setup.scenario.goals.back() ? "goal" : "");
  if (summary.contact) picture.marker(MarkerKind::Contact, trace.positions.back(), "contact");
}

}  // namespace bslnav
