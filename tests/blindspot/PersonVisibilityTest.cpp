#include <bslnav/blindspot/PersonVisibility.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../support/DepthScene.h"
#include "../support/HeapUse.h"

namespace bslnav {
namespace {

using test::cameraAt;
using test::DepthScene;
using test::SceneBox;
using Beam = PlanarScan::Beam;

constexpr double kCamera_m = 0.6, kPerson_m = 1.7;

PersonVisibilityParameters person() {
  PersonVisibilityParameters parameters;
  parameters.height_m = kPerson_m;
  return parameters;
}

PlanarScan viewOf(const mrpt::obs::CObservation3DRangeScan& image) {
  DepthFrame frame;
  frame.assign(image);
  return PersonVisibility(person()).make(frame);
}
PlanarScan viewOf(const DepthScene& scene, double camera_m = kCamera_m) {
  return viewOf(scene.picture(cameraAt(camera_m), 160, 120));
}

/** The beam that points straight ahead. */
std::size_t ahead(const PlanarScan& scan) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < scan.beam.size(); ++i)
    if (scan.cosine[i] > scan.cosine[best]) best = i;
  return best;
}
double rangeAhead(const PlanarScan& scan) { return static_cast<double>(scan.range_m[ahead(scan)]); }

const SceneBox kWall{4.0, 4.2, -9.0, 9.0, 0.0, 3.0};

TEST(PersonVisibility, EndsAtAWall) {
  const PlanarScan view = viewOf({{kWall}, 0.0});
  EXPECT_EQ(view.beam[ahead(view)], Beam::Hit);
  EXPECT_NEAR(rangeAhead(view), 4.0, 0.01);
}

/** What a laser at 0.25 m or the nearest depth point would take for the end of the view. */
TEST(PersonVisibility, ALowTableHidesNobody) {
  const PlanarScan view =
      viewOf({{{1.5, 2.0, -1.0, 1.0, 0.0, 0.5}, kWall}, 0.0});  // the camera sees over it
  EXPECT_NEAR(rangeAhead(view), 4.0, 0.01);
  const PlanarScan legs = viewOf({{{1.5, 2.0, -1.0, 1.0, 0.7, 0.75}, kWall}, 0.0});
  EXPECT_NEAR(rangeAhead(legs), 4.0, 0.01);
}

/** From 0.6 m over an edge of 1.1 m at 2 m the lowest ray rises by a quarter: it is 1.7 m high at
 * 4.4 m, so the heads of people are seen up to there. A pixel is 1/80 high: 0.1 m at 2 m. */
TEST(PersonVisibility, ACounterHidesNobodysHead) {
  const DepthScene scene{{{2.0, 2.5, -9.0, 9.0, 0.0, 1.1}, {6.0, 6.2, -9.0, 9.0, 0.0, 9.0}}, 0.0};
  const PlanarScan view = viewOf(scene.picture(cameraAt(kCamera_m), 160, 120, 9.0));
  EXPECT_EQ(view.beam[ahead(view)], Beam::NoReturn);
  EXPECT_LE(rangeAhead(view), 4.4);
  EXPECT_GE(rangeAhead(view), 1.1 / (0.25 + 2.0 / 80.0));
  const DepthScene higher{{{2.0, 2.5, -9.0, 9.0, 0.0, 1.75}, kWall}, 0.0};
  EXPECT_NEAR(rangeAhead(viewOf(higher)), 2.0, 0.01);
}

TEST(PersonVisibility, AnOverhangDoesNotBlind) {
  const DepthScene scene{{{1.5, 2.0, -9.0, 9.0, 1.0, 3.0}, kWall}, 0.0};
  EXPECT_NEAR(rangeAhead(viewOf(scene)), 4.0, 0.01);
}

/** Without walls the floor is what is seen: up to where a pixel pair still has a depth. */
TEST(PersonVisibility, SeesAsFarAsTheFloor) {
  const PlanarScan view = viewOf(DepthScene{});
  EXPECT_EQ(view.hits(), 0);
  EXPECT_EQ(view.beam[ahead(view)], Beam::NoReturn);
  EXPECT_GT(rangeAhead(view), 4.0);
  EXPECT_LE(rangeAhead(view), 6.0);
}

TEST(PersonVisibility, APixelWithoutDepthSeesNobody) {
  auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(kCamera_m), 160, 120);
  for (int v = 0; v < 120; ++v)
    for (int u = 60; u < 100; ++u) image.rangeImage(v, u) = 0;
  const PlanarScan view = viewOf(image);
  EXPECT_EQ(view.beam[ahead(view)], Beam::Dropped);
  EXPECT_GT(view.hits(), 20);
}

TEST(PersonVisibility, NoSinglePixelSeesThroughAWall) {
  auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(kCamera_m), 160, 120);
  image.rangeImage(60, 80) = 5500;
  EXPECT_NEAR(rangeAhead(viewOf(image)), 4.0, 0.01);
}

TEST(PersonVisibility, ACameraAbovePeopleSeesNobody) {
  const PlanarScan view = viewOf({{kWall}, 0.0}, 1.8);
  EXPECT_EQ(view.dropped(), view.size());
}

TEST(PersonVisibility, AllocatesNothingTheSecondTime) {
  DepthFrame frame;
  frame.assign(DepthScene{{kWall}, 0.0}.picture(cameraAt(kCamera_m)));
  PersonVisibility visibility;
  visibility.make(frame);
  const long before = test::heapUse().allocations;
  visibility.make(frame);
  EXPECT_EQ(test::heapUse().allocations, before);
}

/** Boxes anywhere before an opaque wall. */
DepthScene clutter(double wall_m) {
  DepthScene scene{{{wall_m, wall_m + 0.2, -20.0, 20.0, 0.0, 9.0}}, 0.0};
  const auto metres = [](int low_cm, int high_cm) {
    return *rc::gen::inRange(low_cm, high_cm) / 100.0;
  };
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
    const double x = metres(50, 550), y = metres(-300, 300), z = metres(-20, 150);
    scene.boxes.push_back({x, x + metres(5, 100), y, y + metres(5, 200), std::max(0.0, z),
                           std::max(0.0, z) + metres(5, 200)});
  }
  return scene;
}

RC_GTEST_PROP(PersonVisibility, NeverSeesThroughAnOpaqueWall, ()) {
  const double wall_m = *rc::gen::inRange(100, 550) / 100.0;
  const double pitch = *rc::gen::inRange(-20, 30) / 100.0;
  const PlanarScan view = viewOf(clutter(wall_m).picture(cameraAt(kCamera_m, pitch), 80, 60));
  for (std::size_t i = 0; i < view.beam.size(); ++i)  // a beam is 1.05 pixels wide
    RC_ASSERT(view.range_m[i] * view.cosine[i] <= static_cast<float>(wall_m) * 1.02f + 0.002f);
}

/** The rule as it is written, for one distance: some pixel and the one above it see past it at the
 * height of people. */
bool isSeen(const mrpt::obs::CObservation3DRangeScan& image, double angle, double halfWidth,
            double range_m) {
  const auto& camera = image.cameraParams;
  const auto passes = [&](int v, int u) {
    const auto tip = image.sensorPose.composePoint(mrpt::math::TPoint3D(
                         1.0, (camera.cx() - u) / camera.fx(), (camera.cy() - v) / camera.fy())) -
                     image.sensorPose.translation();
    const double across = std::hypot(tip.x, tip.y);
    const double z = image.sensorPose.z() + range_m * tip.z / across;
    const double depth_m = 0.001 * image.rangeImage(v, u);
    const bool isDepth = depth_m <= static_cast<double>(image.maxRange);
    return isDepth && depth_m * across >= range_m && z >= 0.0 && z <= kPerson_m;
  };
  for (int v = 1; v < int(camera.nrows); ++v)
    for (int u = 0; u < int(camera.ncols); ++u) {
      const auto ray = image.sensorPose.composePoint(mrpt::math::TPoint3D(
                           1.0, (camera.cx() - u) / camera.fx(), (camera.cy() - v) / camera.fy())) -
                       image.sensorPose.translation();
      if (std::abs(std::atan2(ray.y, ray.x) - angle) > halfWidth) continue;
      if (passes(v, u) && passes(v - 1, u)) return true;
    }
  return false;
}

/** Every beam's range is the largest distance of the rule, and somebody would be seen all the way
 * up to there. Pixels at the edge of a beam may count to the next one: half a millirad to and fro.
 */
RC_GTEST_PROP(PersonVisibility, IsTheRuleAsItIsWritten, ()) {
  constexpr double kWidth = 1.05 / 20.0;  // of a beam: more than a pixel of 1/20
  const double pitch = *rc::gen::inRange(-20, 30) / 100.0;
  const auto image = clutter(5.5).picture(cameraAt(kCamera_m, pitch), 40, 30);
  const PlanarScan view = viewOf(image);
  for (std::size_t i = 0; i < view.beam.size(); ++i) {
    const double angle = std::atan2(view.sine[i], view.cosine[i]), range = view.range_m[i];
    for (const double part : {0.3, 0.6, 0.9, 0.999})
      if (range > 0.0) RC_ASSERT(isSeen(image, angle, 0.5 * kWidth + 5e-4, part * range));
    for (double beyond = range + 0.01; beyond < 6.0; beyond += 0.2)
      RC_ASSERT(!isSeen(image, angle, 0.5 * kWidth - 5e-4, beyond));
  }
}

}  // namespace
}  // namespace bslnav
