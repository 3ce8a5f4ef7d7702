#include <bslnav/navigation/ReactivePlanner.h>
#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/nav/holonomic/CHolonomicFullEval.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>

#include "../planning/DwaGenerators.h"
#include "PtgRig.h"

namespace bslnav {
namespace {

constexpr double kPeriod_s = 0.1;

class ReactivePlannerTest : public testing::Test {
 protected:
  ReactivePlanner make(NavigatorType type) {
    parameters.type = type;
    const FootprintCover cover({}, 0.05, test::noInflation());
    return ReactivePlanner(parameters, {}, limits, cover, footprint, kPeriod_s);
  }
  /** Drives a robot that does as it is told, for some cycles. */
  void drive(ReactivePlanner& planner, const CostGrid& costs, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      const DwaResult& result = planner.plan({pose, twist, way, way.back()}, costs);
      const auto allowed = limited(result.command, twist, limits, kPeriod_s);
      EXPECT_NEAR(result.command.vx, allowed.vx, 1e-9);
      EXPECT_NEAR(result.command.omega, allowed.omega, 1e-9);
      twist = result.command;
      pose = pose + mrpt::math::TPose2D(twist.vx * kPeriod_s, 0.0, twist.omega * kPeriod_s);
    }
  }

  NavigatorParameters parameters;
  RobotLimits limits;
  Footprint footprint;
  std::vector<mrpt::math::TPoint2D> way = test::straightPath(4.0);
  mrpt::math::TPose2D pose;
  mrpt::math::TTwist2D twist;
};

TEST_F(ReactivePlannerTest, BothEnginesDriveToTheGoalWithinTheLimits) {
  for (const auto type : {NavigatorType::Ptg, NavigatorType::Mrpt}) {
    pose = {};
    twist = {};
    ReactivePlanner planner = make(type);
    drive(planner, test::freeSpace(), 60);
    EXPECT_GT(pose.x, 2.0);
    EXPECT_LT(std::abs(pose.y), 0.2);
  }
}

TEST_F(ReactivePlannerTest, OursKnowsItsCandidatesAndMrptsDoesNot) {
  ReactivePlanner ours = make(NavigatorType::Ptg), stock = make(NavigatorType::Mrpt);
  const CostGrid costs = test::freeSpace();
  const DwaResult& result = ours.plan({{}, {0.3, 0.0, 0.0}, way, way.back()}, costs);
  EXPECT_EQ(result.candidates.size(), 2U * 61 * 20);  // two PTGs of 61 paths at 20 speeds
  ASSERT_GE(result.best, 0);
  EXPECT_EQ(result.chosenVelocity().omega, 0.0);
  EXPECT_TRUE(stock.plan({{}, {0.3, 0.0, 0.0}, way, way.back()}, costs).candidates.empty());
}

TEST_F(ReactivePlannerTest, BrakesWhenThereIsNoWay) {
  ReactivePlanner planner = make(NavigatorType::Ptg);
  twist = {0.4, 0.0, 0.0};
  const CostGrid wall = test::wallFrom(0.1, kLethalCost);
  const DwaResult& result = planner.plan({pose, twist, way, way.back()}, wall);
  EXPECT_EQ(result.status, DwaResult::Status::NoAdmissible);
  EXPECT_NEAR(result.command.vx, 0.35, 1e-9);  // 0.5 m/s² for 0.1 s
}

TEST_F(ReactivePlannerTest, WritesALogThatMrptReadsWithAScoreForEveryPath) {
  const auto directory = std::filesystem::path(testing::TempDir()) / "bslnav_reactive_planner_test";
  std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  parameters.navlog = directory.string();
  {
    ReactivePlanner planner = make(NavigatorType::Ptg);
    drive(planner, test::freeSpace(), 5);
  }
  mrpt::io::CFileGZInputStream file((directory / "log_000.reactivenavlog").string());
  auto archive = mrpt::serialization::archiveFrom(file);
  mrpt::nav::CLogFileRecord::Ptr record;
  int records = 0;
  try {
    for (;; ++records) record = archive.ReadObject<mrpt::nav::CLogFileRecord>();
  } catch (const std::exception&) {  // the end
  }
  EXPECT_EQ(records, 5);
  ASSERT_TRUE(record);
  ASSERT_GE(record->infoPerPTG.size(), 2U);
  const auto scores = std::dynamic_pointer_cast<mrpt::nav::CLogFileRecord_FullEval>(
      record->infoPerPTG.front().HLFR);
  ASSERT_TRUE(scores);
  EXPECT_EQ(scores->dirs_eval.back().size(), 61U);
  EXPECT_GT(record->infoPerPTG.front().evalFactors["holo_stage_eval"], 0.0);
  std::filesystem::remove_all(directory);
}

TEST_F(ReactivePlannerTest, SaysWhatIsWrongWithMrptsConfiguration) {
  parameters.mrptConfig = "/no/such.ini";
  EXPECT_THROW(make(NavigatorType::Mrpt), std::exception);
  parameters.mrptConfig = dataDirectory() + "/config/scenarios/s1.ini";
  try {
    make(NavigatorType::Mrpt);
    FAIL();
  } catch (const std::exception& problem) {
    EXPECT_THAT(problem.what(), testing::HasSubstr("PTG_COUNT"));
    EXPECT_THAT(problem.what(), testing::Not(testing::HasSubstr("backtrace")));
  }
}

}  // namespace
}  // namespace bslnav
