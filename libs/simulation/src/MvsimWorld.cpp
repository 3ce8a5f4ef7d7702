#include <bslnav/simulation/MvsimWorld.h>
#include <bslnav/simulation/WorldShape.h>

#include <algorithm>
#include <map>

#include "MvsimRobot.h"
#include "MvsimXml.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

struct MvsimBlock {
  std::string name, colour;
  TPoint2D centre;
  std::vector<TPoint2D> polygon;  // around the centre
  double zMin_m, zMax_m;
  bool tangible;
};

void write(MvsimXml& xml, const MvsimBlock& block) {
  xml.open("block", {{"name", block.name}});
  xml.leaf("static", "true");
  if (!block.tangible) xml.leaf("intangible", "true");
  xml.leaf("color", block.colour);
  xml.leaf("zmin", xmlNumbers({block.zMin_m}));
  xml.leaf("zmax", xmlNumbers({block.zMax_m}));
  writeShape(xml, block.polygon);
  xml.leaf("init_pose", xmlNumbers({block.centre.x, block.centre.y, 0.0}));
  xml.leaf("skip_elevation_adjust");  // else it would be put on top of what stands below it
  xml.close();
}

bool meetsALaser(double zMin_m, double zMax_m, const SimulationCase& simulated) {
  return std::any_of(simulated.lasers.begin(), simulated.lasers.end(), [&](const auto& laser) {
    return laser.second.z_m >= zMin_m && laser.second.z_m <= zMax_m;
  });
}

void writeSolids(MvsimXml& xml, const SimulationCase& simulated) {
  std::map<std::string, int> count;  // a wall has a solid for each segment
  for (const WorldShape& shape : worldShapes(simulated.world)) {
    const int n = ++count[shape.section];
    auto polygon = shape.isCylinder() ? mvsimCircle(shape.radius_m) : shape.polygon;
    if (!shape.isCylinder())
      for (TPoint2D& corner : polygon) corner = corner - shape.centre;
    write(xml, {n == 1 ? shape.section : shape.section + "#" + std::to_string(n), "#9a9a9a",
                shape.centre, polygon, shape.zMin_m, shape.zMax_m,
                meetsALaser(shape.zMin_m, shape.zMax_m, simulated)});
  }
}

void writePeople(MvsimXml& xml, const SimulationCase& simulated) {
  for (const auto& [name, person] : simulated.world.pedestrians)
    write(xml, {mvsimPersonName(name), "#cc4499", person.path_m.front(),
                mvsimCircle(person.radius_m), 0.0, person.height_m, true});
}

void writeFloor(MvsimXml& xml, const WorldParameters& world) {
  const WorldBounds bounds = worldBounds(world);
  xml.open("element", {{"class", "horizontal_plane"}});
  xml.leaf("x_min", xmlNumbers({bounds.lower.x - 1.0}));
  xml.leaf("x_max", xmlNumbers({bounds.upper.x + 1.0}));
  xml.leaf("y_min", xmlNumbers({bounds.lower.y - 1.0}));
  xml.leaf("y_max", xmlNumbers({bounds.upper.y + 1.0}));
  xml.leaf("z", "0");
  xml.leaf("color", "#e8e8e8");
  xml.close();
}

}  // namespace

std::string mvsimPersonName(const std::string& pedestrian) { return "pedestrian:" + pedestrian; }

std::string mvsimWorld(const SimulationCase& simulated) {
  MvsimXml xml;
  xml.open("mvsim_world", {{"version", "1.0"}});
  xml.comment("Lengths in metres, angles in degrees, times in seconds; written by bslnav.");
  xml.leaf("simul_timestep", xmlNumbers({SimulationEngine::kSubstep_s}));
  writeFloor(xml, simulated.world);
  writeSolids(xml, simulated);
  writePeople(xml, simulated);
  writeRobot(xml, simulated);
  xml.close();
  return xml.text();
}

}  // namespace bslnav
