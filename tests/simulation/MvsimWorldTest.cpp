#include <bslnav/config/Error.h>
#include <bslnav/simulation/MvsimWorld.h>
#include <bslnav/simulation/WorldShape.h>
#include <gmock/gmock.h>

#include <boost/property_tree/xml_parser.hpp>
#include <functional>
#include <sstream>

#include "TestWorld.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using testing::HasSubstr;
using Tree = boost::property_tree::ptree;

/** A wall of two segments, a turned box, a pole, an overhang, a person, a laser at 0.2 m. */
SimulationCase furnished() {
  SimulationCase simulated;
  simulated.world.walls["w"].points_m = {{-2, 3}, {4, 3}, {4, -1.5}};
  simulated.world.boxes["b"] = test::box({1.5, -0.75, 0.5}, 0.8, 0.4, 0.1, 0.35);
  simulated.world.boxes["shelf"] = test::box({-1.0, 1.0, 0.0}, 0.5, 0.5, 1.2, 1.5);
  simulated.world.cylinders["c"] = {2.5, 1.25, 0.05, 0.0, 2.0, true};
  simulated.world.pedestrians["p"] = test::walker({{3, 0}, {0, 3}}, 1.0);
  simulated.lasers["front"] = LaserParameters{};
  simulated.start = {0.25, -0.5, M_PI / 2};
  return simulated;
}

/** The world file as a tree; a file that is not well-formed throws. */
Tree parsed(const SimulationCase& simulated) {
  std::istringstream text(mvsimWorld(simulated));
  Tree tree;
  boost::property_tree::read_xml(text, tree, boost::property_tree::xml_parser::trim_whitespace);
  return tree.get_child("mvsim_world");
}

const Tree& named(const Tree& world, const std::string& kind, const std::string& name) {
  for (const auto& [tag, element] : world)
    if (tag == kind && element.get<std::string>("<xmlattr>.name") == name) return element;
  throw std::runtime_error("no " + kind + " " + name);
}

std::vector<TPoint2D> cornersOf(const Tree& owner) {
  std::vector<TPoint2D> corners;
  for (const auto& [tag, point] : owner.get_child("shape")) {
    std::istringstream numbers(point.data());
    corners.emplace_back();
    numbers >> corners.back().x >> corners.back().y;
  }
  return corners;
}

TPoint2D centreOf(const Tree& block) {
  std::istringstream numbers(block.get<std::string>("init_pose"));
  TPoint2D centre;
  numbers >> centre.x >> centre.y;
  return centre;
}

TEST(MvsimWorld, EveryPolygonKeepsItsCornersAndHeights) {
  const SimulationCase simulated = furnished();
  const Tree world = parsed(simulated);
  std::map<std::string, int> count;
  for (const WorldShape& shape : worldShapes(simulated.world)) {
    const int n = ++count[shape.section];
    const Tree& block =
        named(world, "block", n == 1 ? shape.section : shape.section + "#" + std::to_string(n));
    EXPECT_NEAR(block.get<double>("zmin"), shape.zMin_m, 1e-6) << shape.section;
    EXPECT_NEAR(block.get<double>("zmax"), shape.zMax_m, 1e-6) << shape.section;
    EXPECT_EQ(block.get<std::string>("static"), "true");
    if (shape.isCylinder()) continue;
    const auto corners = cornersOf(block);
    ASSERT_EQ(corners.size(), shape.polygon.size());
    for (std::size_t i = 0; i < corners.size(); ++i)  // centre and corner are rounded to 1 µm each
      EXPECT_LT((centreOf(block) + corners[i] - shape.polygon[i]).norm(), 2e-6) << shape.section;
  }
  EXPECT_EQ(count["wall:w"], 2);
}

TEST(MvsimWorld, CirclesStayWithinThirteenPerMille) {
  const Tree world = parsed(furnished());
  const std::tuple<const char*, TPoint2D, double> circles[] = {{"cylinder:c", {2.5, 1.25}, 0.05},
                                                               {"pedestrian:p", {3, 0}, 0.25}};
  for (const auto& [name, centre, radius_m] : circles) {
    const Tree& block = named(world, "block", name);
    EXPECT_LT((centreOf(block) - centre).norm(), 1e-6);
    const auto corners = cornersOf(block);
    ASSERT_EQ(corners.size(), 14u);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const TPoint2D side = (corners[i] + corners[(i + 1) % corners.size()]) * 0.5;
      EXPECT_NEAR(corners[i].norm(), radius_m, 0.013 * radius_m);
      EXPECT_NEAR(side.norm(), radius_m, 0.013 * radius_m);
    }
  }
}

/* The laser's plane is at 0.2 m: the box (0.1 to 0.35 m) meets it, the shelf (1.2 m up) does not.
 */
TEST(MvsimWorld, SolidsThatNoLaserMeetsAreIntangible) {
  const Tree world = parsed(furnished());
  EXPECT_EQ(named(world, "block", "box:shelf").get<std::string>("intangible", ""), "true");
  EXPECT_EQ(named(world, "block", "box:b").get<std::string>("intangible", ""), "");
}

TEST(MvsimWorld, RobotStandsAtTheStartWithItsSensors) {
  SimulationCase simulated = furnished();
  simulated.outline.polygon = {{0.45, 0.25}, {-0.25, 0.25}, {-0.25, -0.25}, {0.45, -0.25}};
  simulated.lasers["front"].x_m = 0.4;
  simulated.cameras["eye"].pitch_rad = M_PI / 6;
  const Tree world = parsed(simulated), robot = named(world, "vehicle", "robot");
  EXPECT_EQ(robot.get<std::string>("init_pose"), "0.25 -0.5 90");
  EXPECT_EQ(cornersOf(robot.get_child("dynamics.chassis")), simulated.outline.polygon);
  EXPECT_EQ(robot.get<std::string>("dynamics.controller.<xmlattr>.class"), "twist_ideal");
  const Tree& laser = named(robot, "sensor", "front");
  EXPECT_EQ(laser.get<std::string>("pose_3d"), "0.4 0 0.2 0 0 0");
  EXPECT_EQ(laser.get<int>("nrays"), 683);
  EXPECT_NEAR(laser.get<double>("fov_degrees"), 240.0, 1e-6);
  EXPECT_NEAR(laser.get<double>("max_range"), 5.6, 1e-6);
  const Tree& camera = named(robot, "sensor", "eye");
  EXPECT_EQ(camera.get<std::string>("pose_3d"), "0 0 0.6 0 30 0");
  EXPECT_NEAR(camera.get<double>("depth_cx"), 159.5, 1e-6);  // pixels 0 to 319
}

TEST(MvsimWorld, NamesAreEscaped) {
  SimulationCase simulated = furnished();
  const std::string name = "Tom & <Jerry>'s \"bin\"";
  simulated.world.cylinders[name] = {0.0, 2.0, 0.1, 0.0, 1.0, true};
  simulated.lasers[name] = LaserParameters{};
  const Tree world = parsed(simulated);
  EXPECT_NO_THROW(named(world, "block", "cylinder:" + name));
  EXPECT_NO_THROW(named(named(world, "vehicle", "robot"), "sensor", name));
}

TEST(MvsimWorld, SameCaseGivesTheSameBytes) {
  const std::string first = mvsimWorld(furnished());
  EXPECT_EQ(mvsimWorld(furnished()), first);
  SimulationCase other = furnished();
  other.world.cylinders["c"].x_m += 0.001;
  EXPECT_NE(mvsimWorld(other), first);
}

std::string refusalOf(const SimulationCase& simulated) {
  try {
    mvsimWorld(simulated);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(MvsimWorld, RefusesRobotsThatMvsimDoesNotHave) {
  SimulationCase simulated = furnished();
  simulated.robot.kinematics = BaseKinematics::Holonomic;
  EXPECT_THAT(refusalOf(simulated), HasSubstr("[simulated_robot] kinematics"));
  simulated = furnished();
  for (int i = 0; i < 15; ++i)
    simulated.outline.polygon.emplace_back(std::cos(i * 0.4), std::sin(i * 0.4));
  EXPECT_THAT(refusalOf(simulated), HasSubstr("[footprint] polygon_m"));
}

}  // namespace
}  // namespace bslnav
