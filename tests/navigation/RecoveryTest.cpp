#include <bslnav/navigation/Recovery.h>
#include <gmock/gmock.h>

#include <algorithm>

namespace bslnav {
namespace {

using Step = Recovery::Step;
using testing::ElementsAre;

/** A clock that calls recovery ten times a second. */
class RecoveryTest : public testing::Test {
 protected:
  static RecoveryParameters parameters() {
    RecoveryParameters p;  // 1.5 s patience, 8 s stall, 4 s a step, 0.2 m progress, 0.3 m back
    p.rounds = 2;
    return p;
  }
  Step update(bool blocked, bool stepDone = false) {
    time_s += 0.1;
    return recovery.update(time_s, pose, blocked, stepDone);
  }
  /** The steps, without repetitions, of this many seconds; every one is done at once or never. */
  std::vector<Step> during(double seconds, bool blocked, bool stepsDone) {
    std::vector<Step> steps;
    for (int i = 0; i < static_cast<int>(seconds / 0.1); ++i) {
      const Step step = update(blocked, stepsDone);
      if (steps.empty() || steps.back() != step) steps.push_back(step);
    }
    return steps;
  }

  Recovery recovery{parameters()};
  mrpt::math::TPose2D pose;
  double time_s = 0.0;
};

TEST_F(RecoveryTest, DoesNothingWhileTheRobotMoves) {
  for (int i = 0; i < 300; ++i) {
    pose.x += 0.05;
    ASSERT_EQ(update(false), Step::None);
  }
}

TEST_F(RecoveryTest, WaitsForItsPatienceAndBeginsAfreshWhenFree) {
  EXPECT_THAT(during(1.4, true, false), ElementsAre(Step::None));
  EXPECT_THAT(during(0.1, false, false), ElementsAre(Step::None));
  EXPECT_THAT(during(1.4, true, false), ElementsAre(Step::None));
}

TEST_F(RecoveryTest, ReplansTurnsBacksOffAndGivesUpAfterItsRounds) {
  EXPECT_THAT(during(10.0, true, true),
              ElementsAre(Step::None, Step::Replan, Step::RotateToPath, Step::BackOff,  //
                          Step::None, Step::Replan, Step::RotateToPath, Step::BackOff,  //
                          Step::None, Step::GiveUp));
}

TEST_F(RecoveryTest, AStepThatIsNeverDoneEndsAfterItsTime) {
  during(1.5, true, false);
  ASSERT_EQ(update(true), Step::Replan);
  EXPECT_THAT(during(3.9, true, false), ElementsAre(Step::Replan));
  EXPECT_THAT(during(0.3, true, false).back(), Step::RotateToPath);
}

TEST_F(RecoveryTest, AStallCountsAsBlocked) {
  EXPECT_THAT(during(7.9, false, false), ElementsAre(Step::None));
  EXPECT_THAT(during(0.4, false, false), ElementsAre(Step::None, Step::Replan));
}

TEST_F(RecoveryTest, ProgressResetsTheRounds) {
  while (update(true, true) != Step::BackOff) {
  }
  EXPECT_EQ(recovery.round(), 1);
  update(false, true);
  pose.x += 0.51;  // farther than 0.2 m and 0.3 m of backing off
  update(false);
  EXPECT_EQ(recovery.round(), 0);
}

TEST_F(RecoveryTest, BackingOffAndComingBackIsNoProgress) {
  std::vector<Step> steps;
  for (int i = 0; i < 400 && (steps.empty() || steps.back() != Step::GiveUp); ++i) {
    const double wanted = steps.empty() || steps.back() != Step::BackOff ? 0.0 : -0.3;
    pose.x += std::clamp(wanted - pose.x, -0.05, 0.05);
    steps.push_back(update(pose.x > -0.01,
                           pose.x < -0.29 || (!steps.empty() && steps.back() != Step::BackOff)));
  }
  EXPECT_EQ(steps.back(), Step::GiveUp);
}

TEST_F(RecoveryTest, StaysGivenUpUntilReset) {
  during(10.0, true, true);
  pose.x += 5.0;
  EXPECT_EQ(update(false), Step::GiveUp);
  recovery.reset();
  EXPECT_EQ(update(false), Step::None);
}

TEST_F(RecoveryTest, WaitsForEverWhenDisabled) {
  RecoveryParameters off = parameters();
  off.enabled = false;
  recovery = Recovery(off);
  EXPECT_THAT(during(60.0, true, false), ElementsAre(Step::None));
}

}  // namespace
}  // namespace bslnav
