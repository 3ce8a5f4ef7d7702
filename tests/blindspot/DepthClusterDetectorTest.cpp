#include <bslnav/blindspot/DepthClusterDetector.h>
#include <bslnav/config/Error.h>
#include <gtest/gtest.h>

#include "../support/DepthScene.h"

namespace bslnav {
namespace {

using test::DepthScene;

DepthClusterParameters withEngine(DepthClusterParameters::Engine engine) {
  DepthClusterParameters parameters;
  parameters.engine = engine;
  parameters.fewestVoxels = 20;
  return parameters;
}

class DepthClusterDetectorOf : public testing::TestWithParam<DepthClusterParameters::Engine> {
 protected:
  std::vector<BlindSpot> detect(const DepthScene& scene, DepthClusterParameters p) {
    DepthFrame frame;
    frame.assign(scene.picture(test::cameraAt(0.6, 0.1), 160, 120));
    return DepthClusterDetector(p).detect({&frame});
  }
  std::vector<BlindSpot> detect(const DepthScene& scene) {
    return detect(scene, withEngine(GetParam()));
  }
};

TEST_P(DepthClusterDetectorOf, FindsWhereTheNearestOnEachSideEnds) {
  // A wall on the right from 1.2 to 3 m, y = −0.9 to −0.7: its face and its near end are seen.
  // Two boxes on the left, the farther one (x from 4 m) does not count; of the nearer one, at 2 to
  // 2.4 m and y = 0.8 to 1.2, front and right side are seen.
  const DepthScene scene{{{1.2, 3.0, -0.9, -0.7, 0.0, 2.0},
                          {2.0, 2.4, 0.8, 1.2, 0.0, 2.0},
                          {4.0, 4.5, 0.5, 1.0, 0.0, 2.0}},
                         0.0};
  const auto spots = detect(scene);
  ASSERT_EQ(spots.size(), 2U);
  EXPECT_NEAR(spots[0].position.x, 2.4, 0.06);
  EXPECT_NEAR(spots[0].position.y, 1.0, 0.06);
  EXPECT_NEAR(spots[1].position.x, 3.0, 0.06);
  EXPECT_NEAR(spots[1].position.y, -0.8, 0.06);
}

TEST_P(DepthClusterDetectorOf, KnowsOneSideOnly) {
  const auto spots = detect({{{2.0, 2.4, 0.8, 1.2, 0.0, 2.0}}, 0.0});
  ASSERT_EQ(spots.size(), 1U);
  EXPECT_GT(spots[0].position.y, 0.0);
}

TEST_P(DepthClusterDetectorOf, LeavesOutWhatIsSmall) {
  const DepthScene pole{{{1.5, 1.56, 0.5, 0.56, 0.0, 1.2}}, 0.0};  // 2 x 1 x 22 voxels at most
  auto parameters = withEngine(GetParam());
  EXPECT_EQ(detect(pole, parameters).size(), 1U);
  parameters.fewestVoxels = 100;
  EXPECT_TRUE(detect(pole, parameters).empty());
}

TEST_P(DepthClusterDetectorOf, CutsOffGroundAndCeiling) {
  const DepthScene hall{{{0.0, 10.0, -10.0, 10.0, 2.5, 2.6}}, 0.0};
  EXPECT_TRUE(detect(hall).empty());
  const DepthScene step{{{1.5, 3.0, -1.0, 1.0, 0.0, 0.08}}, 0.0};
  EXPECT_TRUE(detect(step).empty());
}

INSTANTIATE_TEST_SUITE_P(Engines, DepthClusterDetectorOf,
                         testing::Values(DepthClusterParameters::Engine::Dense,
                                         DepthClusterParameters::Engine::Pcl),
                         [](const auto& test) {
                           return test.param == DepthClusterParameters::Engine::Dense ? "Dense"
                                                                                      : "Pcl";
                         });

TEST(DepthClusterParameters, AreRefusedWhenTheyDoNotGoTogether) {
  const auto isRefused = [](auto&& change) {
    DepthClusterParameters parameters;
    change(parameters);
    try {
      parameters.check();
    } catch (const Error& problem) {
      return std::string(problem.what()).find("depth_clusters") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(isRefused([](auto&) {}));
  EXPECT_TRUE(isRefused([](auto& p) { p.zMax_m = p.zMin_m; }));
  EXPECT_TRUE(isRefused([](auto& p) { p.leaf_m = 0.02; }));  // 86 layers, a word has 64 bits
  EXPECT_FALSE(isRefused([](auto& p) {
    p.leaf_m = 0.02;
    p.engine = DepthClusterParameters::Engine::Pcl;
  }));
}

}  // namespace
}  // namespace bslnav
