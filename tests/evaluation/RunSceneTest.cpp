#include <bslnav/evaluation/RunScene.h>
#include <bslnav/evaluation/ScenePicture.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/opengl/CPointCloud.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "EvaluationRig.h"

namespace bslnav {
namespace {

using mrpt::math::TBoundingBoxf;
using mrpt::opengl::COpenGLScene;
using test::hall;

/** The hall with one of everything. */
SimulationSetup furnishedHall() {
  SimulationSetup setup = hall();
  setup.navigation.method.number = 4;
  setup.navigation.depth.enabled = true;
  setup.navigation.blindSpots.source = BlindSpotSource::ScanJumps;
  setup.cameras["rgbd"].columns = 64;
  setup.cameras["rgbd"].rows = 48;
  setup.world.boxes["desk"] = {{3.0, 1.2, 0.0}, 1.0, 0.6, 0.7, 0.75, false};
  setup.world.cylinders["pole"] = {2.0, -1.0, 0.1, 0.0, 1.5, true};
  auto& person = setup.world.pedestrians["visitor"];
  person.path_m = {{4.0, -1.0}, {4.0, -1.5}};
  person.triggerLine_m = {{8.0, -2.0}, {8.0, 2.0}};
  return setup;
}

/** Saved after some cycles and loaded again, as MRPT's viewer does. */
COpenGLScene::Ptr savedScene(const SimulationSetup& setup, int cycles) {
  RunScene scene(setup, setup.makeMap());
  runSimulation(setup, 1, [&](const SimulationMoment& moment) {
    scene.observe(moment);
    return moment.record.index + 1 < cycles;
  });
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string file =
      testing::TempDir() + "bslnav_" + std::to_string(getpid()) + "_" + info->name() + ".3Dscene";
  saveScene(*scene.make(), file);
  auto loaded = COpenGLScene::Create();
  EXPECT_TRUE(loaded->loadFromFile(file));
  std::remove(file.c_str());
  return loaded;
}

TBoundingBoxf boxOf(COpenGLScene& scene, const std::string& name) {
  const auto object = scene.getByName(name);
  if (!object) {
    ADD_FAILURE() << "no object " << name;
    return {};
  }
  const auto box = object->getBoundingBox();
  return {box.min.cast<float>(), box.max.cast<float>()};
}

void expectBox(const TBoundingBoxf& box, const TBoundingBoxf& expected, float tolerance = 1e-3f) {
  EXPECT_NEAR(box.min.x, expected.min.x, tolerance);
  EXPECT_NEAR(box.min.y, expected.min.y, tolerance);
  EXPECT_NEAR(box.min.z, expected.min.z, tolerance);
  EXPECT_NEAR(box.max.x, expected.max.x, tolerance);
  EXPECT_NEAR(box.max.y, expected.max.y, tolerance);
  EXPECT_NEAR(box.max.z, expected.max.z, tolerance);
}

TEST(RunScene, HoldsTheWorldWhereItIs) {
  const auto scene = savedScene(furnishedHall(), 1);
  expectBox(boxOf(*scene, "box:desk"), {{2.5f, 0.9f, 0.7f}, {3.5f, 1.5f, 0.75f}});
  // a cylinder of MRPT is a polygon of slices inside the circle
  expectBox(boxOf(*scene, "cylinder:pole"), {{1.9f, -1.1f, 0.0f}, {2.1f, -0.9f, 1.5f}}, 2e-3f);
  expectBox(boxOf(*scene, "person:visitor"), {{3.75f, -1.25f, 0.0f}, {4.25f, -0.75f, 1.7f}}, 2e-3f);
  // the polyline's first segment, (-5, -2) to (9, -2), 0.1 m thick, one end lengthened by half of
  // it
  expectBox(boxOf(*scene, "wall:hall"), {{-5.0f, -2.05f, 0.0f}, {9.05f, -1.95f, 2.0f}});
  for (const char* name : {"wall:hall#2", "wall:hall#3", "wall:hall#4", "floor"})
    EXPECT_TRUE(scene->getByName(name)) << name;
}

TEST(RunScene, HoldsTheRunUpToItsLastCycle) {
  const SimulationSetup setup = furnishedHall();
  const auto scene = savedScene(setup, 21);  // 2 s
  const auto robot = boxOf(*scene, "robot"), driven = boxOf(*scene, "trajectory");
  EXPECT_NEAR(driven.min.x, 0.0f, 1e-3f);
  EXPECT_GT(driven.max.x, 0.5f);  // 2 s at up to 0.56 m/s
  EXPECT_NEAR(driven.max.x, 0.5f * (robot.min.x + robot.max.x), 0.01f);
  EXPECT_NEAR(boxOf(*scene, "goal").max.x, 5.3f, 0.01f);
  EXPECT_GT(boxOf(*scene, "global path").max.x, 4.5f);
  const auto map = setup.makeMap();
  const auto costs = boxOf(*scene, "costs");
  EXPECT_NEAR(costs.min.x, map->getXMin(), 0.051);
  EXPECT_NEAR(costs.max.y, map->getYMax(), 0.051);
  EXPECT_TRUE(scene->getByName("danger zone 1"));  // behind the pole
}

/* The hall's walls: x from -5 to 9, y from -2 to 2, and their inner faces half a thickness in. */
TEST(RunScene, PutsMeasurementsOnWhatTheyMeasured) {
  SimulationSetup setup = furnishedHall();
  setup.lasers["front"].maxRange_m = 20.0;
  const auto scene = savedScene(setup, 21);
  const auto scan = boxOf(*scene, "scan:front"), depth = boxOf(*scene, "depth:rgbd");
  EXPECT_NEAR(scan.max.x, 8.95f, 0.02f);
  EXPECT_NEAR(scan.min.y, -1.95f, 0.02f);
  EXPECT_NEAR(scan.max.y, 1.95f, 0.02f);
  EXPECT_NEAR(scan.min.z, scan.max.z, 1e-6f);
  EXPECT_NEAR(depth.min.z, 0.0f, 0.05f);  // the floor
  EXPECT_GT(depth.max.z, 0.7f);
  const auto cloud =
      std::dynamic_pointer_cast<mrpt::opengl::CPointCloud>(scene->getByName("depth:rgbd"));
  ASSERT_TRUE(cloud);
  EXPECT_GT(cloud->size(), 500U);  // of 64 x 48
}

TEST(RunScene, ShowsTheInstantThatIsAskedFor) {
  SimulationSetup setup = furnishedHall();
  setup.recording.scene_s = 1.0;
  const float at1s = boxOf(*savedScene(setup, 21), "trajectory").max.x;
  setup.recording.scene_s = 0.0;
  EXPECT_LT(at1s, boxOf(*savedScene(setup, 21), "trajectory").max.x);
}

TEST(RunScene, NeedsNoMap) {
  SimulationSetup setup = furnishedHall();
  setup.scenario.map = "none";
  const auto costs = boxOf(*savedScene(setup, 2), "costs");
  EXPECT_NEAR(costs.max.x - costs.min.x, setup.navigation.costmap.width_m, 0.051);
}

TEST(RunScene, NamesAFileThatCannotBeWritten) {
  EXPECT_EQ(test::errorOf([] { saveScene(COpenGLScene(), "/no/such/run.3Dscene"); }),
            "/no/such/run.3Dscene: cannot be written");
}

TEST(ScenePicture, CameraSeesTheWholeBoxAndNotMuchMore) {
  const TBoundingBoxf box({-3.0f, -2.0f, 0.0f}, {9.0f, 4.0f, 2.0f});
  const double aspect = 1.5;
  const auto camera = cameraFor(box, aspect);
  // the tangents of the angles between the corners and the middle of the view
  const double a = mrpt::DEG2RAD(double{camera.getAzimuthDegrees()});
  const double e = mrpt::DEG2RAD(double{camera.getElevationDegrees()});
  double across = 0.0, upwards = 0.0;
  for (const float x : {-3.0f, 9.0f})
    for (const float y : {-2.0f, 4.0f})
      for (const float z : {0.0f, 2.0f}) {
        const double dx = x - 3.0, dy = y - 1.0, dz = z - 1.0;
        const double away = dx * std::cos(a) + dy * std::sin(a);
        const double depth = camera.getZoomDistance() - away * std::cos(e) - dz * std::sin(e);
        across = std::max(across, std::abs(dy * std::cos(a) - dx * std::sin(a)) / depth);
        upwards = std::max(upwards, std::abs(dz * std::cos(e) - away * std::sin(e)) / depth);
      }
  const double half = std::tan(mrpt::DEG2RAD(double{camera.getProjectiveFOVdeg()}) / 2.0);
  EXPECT_LE(across, half * aspect);
  EXPECT_LE(upwards, half);
  EXPECT_GT(std::max(across / (half * aspect), upwards / half), 0.95);
}

TEST(ScenePicture, ShowsTheSolidsOnAWhiteGround) {
  const SimulationSetup setup = furnishedHall();
  RunScene scene(setup, setup.makeMap());
  const RenderedScene rendered = renderScene(*scene.make(), 300, 200);
  if (!rendered.picture) GTEST_SKIP() << rendered.problem;
  const Picture& picture = *rendered.picture;
  ASSERT_EQ(picture.width, 300);
  ASSERT_EQ(picture.height, 200);
  EXPECT_EQ(picture.pixel(1, 1), (Colour{255, 255, 255}));
  int magenta = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Colour c = picture.pixel(x, y);
      magenta += c.r > c.g + 40 && c.b > c.g + 20;
    }
  EXPECT_GT(magenta, 20);    // the person
  EXPECT_LT(magenta, 3000);  // of 60000
}

}  // namespace
}  // namespace bslnav
