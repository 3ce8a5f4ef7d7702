#include <gtest/gtest.h>

#include "../support/HeapUse.h"
#include "DepthCameraRig.h"

namespace bslnav {
namespace {

TEST(DepthCameraMemory, HeldFramesAreNotOverwritten) {
  DepthCamera camera("camera", test::exactCamera(), 1);
  const RayScene scene(test::wallAt(3.0), {});
  const auto first = camera.frame(scene, {}, test::kStamp);
  const auto second = camera.frame(scene, {1.0, 0.0, 0.0}, test::kStamp);
  EXPECT_NE(first, second);
  EXPECT_EQ(first->rangeImage(24, 32), 3000);
  EXPECT_EQ(second->rangeImage(24, 32), 2000);
}

TEST(DepthCameraMemory, ReleasedFramesAreUsedAgainWithoutTheirOldContents) {
  DepthCamera camera("camera", test::exactCamera(), 1);
  const RayScene scene(test::wallAt(3.0), {}), empty({}, {});
  auto frame = camera.frame(scene, {}, test::kStamp);
  const void* address = frame.get();
  frame.reset();
  const auto later = test::kStamp + std::chrono::seconds(1);
  frame = camera.frame(empty, {}, later);
  EXPECT_EQ(frame.get(), address);
  EXPECT_EQ(frame->rangeImage(24, 32), 0);
  EXPECT_EQ(frame->timestamp, later);
}

TEST(DepthCameraMemory, SteadyStateTakesNoMemory) {
  DepthCamera camera("camera", DepthCameraParameters{}, 1);
  RayScene scene(test::wallAt(3.0), {{0.25, 1.7}});
  scene.placePeople({{2.0, 0.0}});
  auto held = camera.frame(scene, {}, test::kStamp);
  auto next = camera.frame(scene, {}, test::kStamp);
  const auto before = test::heapUse().allocations;
  for (int i = 0; i < 20; ++i) {
    held = std::move(next);  // one frame is always held
    next = camera.frame(scene, {0.01 * i, 0.0, 0.0}, test::kStamp);
  }
  EXPECT_EQ(test::heapUse().allocations, before);
}

}  // namespace
}  // namespace bslnav
