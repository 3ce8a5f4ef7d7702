#include <bslnav/evaluation/RunTally.h>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::contactRun;
using test::goalRun;

TEST(RunTally, CountsOutcomesAndCollectsTimesAndClearances) {
  RunSummary standing = contactRun(1), stuck = goalRun(1, 0.0, 2.0), alone = goalRun(1, 30.0, 0.0);
  standing.atFault = false;
  stuck.outcome = Outcome::Stuck;
  stuck.timeToGoal_s.reset();
  alone.minClearance_m.reset();
  const RunTally tally = tallyOf({goalRun(1, 20.0, 0.5), contactRun(1), standing, stuck, alone});
  EXPECT_EQ(tally.runs, 5);
  EXPECT_EQ(tally.goals, 2);
  EXPECT_EQ(tally.contacts, 2);
  EXPECT_EQ(tally.atFault, 1);
  EXPECT_EQ(tally.other, 1);
  EXPECT_THAT(tally.times_s, testing::ElementsAre(20.0, 30.0));
  EXPECT_THAT(tally.clearance_m, testing::ElementsAre(0.5, 0.0, 0.0, 2.0));  // -0.01 counts as 0
}

TEST(Median, IsTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 3.0, 2.0}), 2.5);
  EXPECT_EQ(median({5.0}), 5.0);
  EXPECT_EQ(median({}), 0.0);
}

}  // namespace
}  // namespace bslnav
