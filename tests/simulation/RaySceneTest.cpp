#include <bslnav/simulation/RayScene.h>
#include <gtest/gtest.h>

#include <cmath>

#include "TestWorld.h"

namespace bslnav {
namespace {

constexpr mrpt::math::TPoint3Df kForward(1, 0, 0);
constexpr float kNone = std::numeric_limits<float>::infinity();

float hitAtHeight(const WorldParameters& world, float z) {
  return RayScene(world, {}).rayHit({0, 0, z}, kForward, 10.0f);
}

TEST(RayScene, DistanceToWallIsToItsFace) {
  WorldParameters world;
  world.walls["w"] = test::wall({3, -1}, {3, 1}, 0.2);
  EXPECT_NEAR(hitAtHeight(world, 0.2f), 2.9, 1e-5);  // 3 - 0.2/2
}

TEST(RayScene, SurfaceBeyondMaximumRangeIsNotSeen) {
  WorldParameters world;
  world.walls["w"] = test::wall({3, -1}, {3, 1}, 0.2);
  EXPECT_EQ(RayScene(world, {}).rayHit({0, 0, 0.2f}, kForward, 2.8f), kNone);
}

TEST(RayScene, DistanceToCylinderFollowsTheCircle) {
  WorldParameters world;
  world.cylinders["c"] = {3.0, 0.0, 0.5, 0.0, 2.0, true};
  const RayScene scene(world, {});
  for (const float offset : {0.0f, 0.1f, 0.3f})
    // Circle: x = 3 - sqrt(r² - y²); the prism is within 0.5 mm of it, seen at a slant of at most
    // r/sqrt(r² - y²) = 1.25.
    EXPECT_NEAR(scene.rayHit({0, offset, 1}, kForward, 10.0f),
                3.0f - std::sqrt(0.25f - offset * offset), 0.0007);
}

TEST(RayScene, BeamPassesOverALowBox) {
  WorldParameters world;
  world.boxes["low"] = test::box({2, 0, 0}, 1.0, 1.0, 0.0, 0.15);
  EXPECT_NEAR(hitAtHeight(world, 0.1f), 1.5, 1e-5);
  EXPECT_EQ(hitAtHeight(world, 0.2f), kNone);
}

TEST(RayScene, BeamPassesBelowATableTop) {
  WorldParameters world;
  world.boxes["table"] = test::box({2, 0, 0}, 1.0, 1.0, 0.7, 0.75);
  EXPECT_NEAR(hitAtHeight(world, 0.72f), 1.5, 1e-5);
  EXPECT_EQ(hitAtHeight(world, 0.2f), kNone);
}

TEST(RayScene, TableTopIsSeenFromAboveAndFromBelow) {
  WorldParameters world;
  world.boxes["table"] = test::box({0, 0, 0}, 1.0, 1.0, 0.7, 0.75);
  const RayScene scene(world, {});
  EXPECT_NEAR(scene.rayHit({0.1f, 0.2f, 2.0f}, {0, 0, -1}, 10.0f), 1.25, 1e-5);
  EXPECT_NEAR(scene.rayHit({0.1f, 0.2f, 0.2f}, {0, 0, 1}, 10.0f), 0.5, 1e-5);
}

TEST(RayScene, FloorIsAtHeightZero) {
  const RayScene scene({}, {});
  const float s = std::sqrt(0.5f);
  EXPECT_NEAR(scene.rayHit({5, 5, 1}, {s, 0, -s}, 10.0f), std::sqrt(2.0), 1e-4);  // 1 m down at 45°
}

TEST(RayScene, OuterCornerOfAPolylineIsClosed) {
  WorldParameters world;
  world.walls["w"] = test::wall({0, 0}, {2, 0}, 0.2);
  world.walls["w"].points_m.emplace_back(2, 2);
  // Past the corner point's middle lines, at x = 2.05, y = -0.05: only the lengthened end fills it.
  EXPECT_NEAR(RayScene(world, {}).rayHit({2.05f, -1, 0.2f}, {0, 1, 0}, 10.0f), 0.9, 1e-5);
}

TEST(RayScene, PersonIsSeenWhereItWasMovedAndNotWhereItWas) {
  RayScene scene({}, {{0.25, 1.7}});
  scene.placePeople({{2.0, 0.0}});
  EXPECT_NEAR(scene.rayHit({0, 0, 1}, kForward, 10.0f), 1.75, 0.0006);
  scene.placePeople({{2.0, 1.0}});
  EXPECT_EQ(scene.rayHit({0, 0, 1}, kForward, 10.0f), kNone);
  EXPECT_NEAR(scene.rayHit({0, 1, 1}, kForward, 10.0f), 1.75, 0.0006);
}

TEST(RayScene, BeamPassesOverASmallPerson) {
  RayScene scene({}, {{0.25, 1.1}});
  scene.placePeople({{2.0, 0.0}});
  EXPECT_NE(scene.rayHit({0, 0, 1.09f}, kForward, 10.0f), kNone);
  EXPECT_EQ(scene.rayHit({0, 0, 1.11f}, kForward, 10.0f), kNone);
}

TEST(RayScene, HeadIsSeenFromAbove) {
  RayScene scene({}, {{0.25, 1.5}});
  scene.placePeople({{2.0, 0.0}});
  const float s = std::sqrt(0.5f);
  // 45° down from height 3.5 m: at height 1.5 m after 2 m forward, in the middle of the head.
  EXPECT_NEAR(scene.rayHit({0, 0, 3.5f}, {s, 0, -s}, 10.0f), 2.0 * std::sqrt(2.0), 1e-5);
  // From 3.2 m it enters above the head's height at x = 1.75 and meets the top at x = 1.7: beside
  // it, so the side is met at x = 1.75.
  EXPECT_NEAR(scene.rayHit({0, 0, 3.2f}, {s, 0, -s}, 10.0f), 1.75 * std::sqrt(2.0), 1e-5);
  // From 3.8 m it would meet the top's height at x = 2.3, behind the head: the floor at x = 3.8.
  EXPECT_NEAR(scene.rayHit({0, 0, 3.8f}, {s, 0, -s}, 10.0f), 3.8 * std::sqrt(2.0), 1e-5);
}

TEST(RayScene, PictureCountsHitsInLengthsOfItsDirections) {
  WorldParameters world;
  world.walls["w"] = test::wall({2.1, -5}, {2.1, 5}, 0.2);
  world.walls["w"].zMax_m = 5.0;
  RayImage image;
  image.origin = {0, 0, 1};
  for (int u = -4; u <= 4; ++u)
    image.columns.emplace_back(1.0f, 0.1f * static_cast<float>(u), 0.0f);
  image.rows.resize(2);
  for (std::size_t v = 0; v < 16; ++v)
    image.rows[v / 8].z[v % 8] = 1.5f - 0.2f * static_cast<float>(v);
  for (auto& row : image.rows) row.x = row.y = {};
  RayScene(world, {}).trace(image, 3.0f);
  ASSERT_EQ(image.hits.size(), 9u * 16u);
  for (std::size_t v = 0; v < 16; ++v)
    for (std::size_t u = 0; u < 9; ++u) {
      // The wall is two lengths forward; slopes below −0.5 meet the floor, 1 m down, before it.
      const float slope = image.rows[v / 8].z[v % 8];
      ASSERT_NEAR(image.hits[v * 9 + u], slope < -0.5f ? -1.0f / slope : 2.0f, 1e-5) << u << v;
    }
}

TEST(RayScene, PacketEqualsSingleRays) {
  WorldParameters world;
  world.walls["w"] = test::wall({2, -1}, {3, 1});
  world.boxes["b"] = test::box({-1, 2, 0.3}, 1.0, 0.5);
  RayScene scene(world, {{0.25, 1.7}});
  scene.placePeople({{0.0, -1.5}});
  RayPacket packet;
  for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
    const double angle = 0.1 + 2.0 * M_PI * static_cast<double>(i) / RayPacket::kSize;
    packet.x[i] = static_cast<float>(std::cos(angle));
    packet.y[i] = static_cast<float>(std::sin(angle));
    packet.z[i] = 0.0f;
  }
  const auto distances = scene.rayHits({0, 0, 0.5f}, packet, 5.0f);
  for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
    const float single = scene.rayHit({0, 0, 0.5f}, {packet.x[i], packet.y[i], packet.z[i]}, 5.0f);
    if (std::isinf(single))
      EXPECT_EQ(distances[i], single) << i;
    else
      EXPECT_NEAR(distances[i], single, 1e-5) << i;
  }
}

}  // namespace
}  // namespace bslnav
