#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/simulation/WorldShape.h>
#include <gmock/gmock.h>

#include <fstream>

#include "TestWorld.h"

namespace bslnav {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

void expectRefused(const WorldParameters& world, const std::string& section,
                   const std::string& key) {
  EXPECT_THAT([&] { world.check(); },
              ThrowsMessage<Error>(AllOf(HasSubstr("[" + section + "]"), HasSubstr(key))));
}

TEST(WorldParameters, LoadFromRepeatedSections) {
  const std::string file = testing::TempDir() + "simulation_world.ini";
  std::ofstream(file) << "[wall:left]\npoints_m = 0 1, 4 1\nthickness_m = 0.2\nmapped = false\n"
                         "[box:table]\npose = 1 2 90\nz_min_m = 0.7\nz_max_m = 0.75\n"
                         "[cylinder:pole]\nx_m = 3\nradius_m = 0.05\n"
                         "[pedestrian:anna]\npath_m = 5 -2, 5 0\ntrigger_line_m = 3 -1, 3 1\n";
  WorldParameters world;
  Config config;
  config.bindRepeated("wall", "walls", world.walls);
  config.bindRepeated("box", "boxes", world.boxes);
  config.bindRepeated("cylinder", "cylinders", world.cylinders);
  config.bindRepeated("pedestrian", "people", world.pedestrians);
  config.load({file});
  world.check();
  EXPECT_EQ(world.walls.at("left").points_m.at(1), mrpt::math::TPoint2D(4, 1));
  EXPECT_FALSE(world.walls.at("left").mapped);
  EXPECT_DOUBLE_EQ(world.boxes.at("table").pose.phi, M_PI / 2);
  EXPECT_DOUBLE_EQ(world.boxes.at("table").zMin_m, 0.7);
  EXPECT_DOUBLE_EQ(world.cylinders.at("pole").x_m, 3.0);
  EXPECT_EQ(world.pedestrians.at("anna").triggerLine_m.size(), 2u);
}

TEST(WorldParameters, WallOfLengthZeroIsRefused) {
  WorldParameters world;
  world.walls["w"] = test::wall({1, 1}, {1, 1});
  expectRefused(world, "wall:w", "points_m");
}

TEST(WorldParameters, PathOfOnePointIsRefused) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{1, 1}}, 1.0);
  expectRefused(world, "pedestrian:p", "path_m");
}

TEST(WorldParameters, TriggerLineOfOnePointIsRefused) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{1, 1}, {2, 1}}, 1.0);
  world.pedestrians["p"].triggerLine_m = {{0, 0}};
  expectRefused(world, "pedestrian:p", "trigger_line_m");
}

TEST(WorldParameters, WhoDoesNotSeeTheRobotCannotWalkRoundIt) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{0, 0}, {1, 0}}, 1.0);
  world.pedestrians["p"].walksRoundAfter_s = 2.0;
  expectRefused(world, "pedestrian:p", "walks_round_after_s");
}

TEST(WorldParameters, UpperFaceNotAboveLowerFaceIsRefused) {
  WorldParameters world;
  world.boxes["b"] = test::box({0, 0, 0}, 1.0, 1.0, 0.5, 0.5);
  expectRefused(world, "box:b", "z_max_m");
}

TEST(WorldParameters, NegativeSizesAreRefused) {
  WorldParameters box, cylinder;
  box.boxes["b"] = test::box({0, 0, 0}, 1.0, -1.0);
  expectRefused(box, "box:b", "width_m");
  cylinder.cylinders["c"].radius_m = -0.1;
  expectRefused(cylinder, "cylinder:c", "radius_m");
}

TEST(WorldBounds, HoldShapesAndPaths) {
  WorldParameters world;
  world.walls["w"] = test::wall({0, 1}, {4, 1}, 0.2);
  world.cylinders["c"] = {-1.0, 0.0, 0.5, 0.0, 1.0, true};
  world.pedestrians["p"] = test::walker({{2, -3}, {2, 0}}, 1.0);
  const auto bounds = worldBounds(world);
  EXPECT_NEAR(bounds.lower.x, -1.5, 1e-12);   // cylinder: -1 - 0.5
  EXPECT_NEAR(bounds.upper.x, 4.0, 1e-12);    // the wall's end is not lengthened
  EXPECT_NEAR(bounds.lower.y, -3.25, 1e-12);  // path's point less the person's radius
  EXPECT_NEAR(bounds.upper.y, 1.1, 1e-12);    // half the wall's thickness
}

}  // namespace
}  // namespace bslnav
