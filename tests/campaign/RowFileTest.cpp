#include <bslnav/campaign/RowFile.h>
#include <bslnav/config/Error.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace bslnav {
namespace {

using testing::HasSubstr;

CampaignRow sample(long encounter) {
  CampaignRow row;
  row.encounter = encounter;
  row.family = "doors";
  row.seed = 4123456789U;
  row.method = 5;
  row.engine = "dwa";
  row.sensors = "both";
  row.outcome = "contact";
  row.contact = true;
  row.impactSpeed_mps = 0.0312;
  row.minClearance_m = -0.001;
  row.timeEmpty_s = 17.25;
  row.pathLength_m = 3.5;
  row.lapse_s = 0.2;
  return row;
}

class RowFiles : public testing::Test {
 protected:
  RowFiles() {
    directory_ = testing::TempDir() + "rows-" +
                 testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  std::string path(const std::string& name) const { return directory_ + "/" + name; }
  const std::string& directory() const { return directory_; }

  template <typename Function>
  static std::string messageOf(const Function& function) {
    try {
      function();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::string directory_;
};

TEST_F(RowFiles, ARowIsReadAsItWasWritten) {
  RowFile(path("results.csv")).append(sample(3));
  const auto rows = readRows(path("results.csv"));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].csv(), sample(3).csv());
  EXPECT_EQ(rows[0].seed, 4123456789U);
  EXPECT_TRUE(rows[0].contact);
  EXPECT_FALSE(rows[0].atFault);
  EXPECT_FALSE(rows[0].timeToGoal_s);
  EXPECT_EQ(rows[0].timeEmpty_s, 17.25);
}

TEST_F(RowFiles, GoesOnWhereItEndedAndDropsWhatIsNotWhole) {
  RowFile(path("results.csv")).append(sample(0));
  std::ofstream(path("results.csv"), std::ios::app) << "1,doors,4123";  // cut off
  RowFile file(path("results.csv"));
  EXPECT_EQ(file.rows(), 1);
  file.append(sample(1));
  EXPECT_EQ(readRows(path("results.csv")).size(), 2U);
}

TEST_F(RowFiles, RefusesOtherFilesAndBadRows) {
  std::ofstream(path("other.csv")) << "a,b\n1,2\n";
  EXPECT_THAT(messageOf([&] { RowFile file(path("other.csv")); }), HasSubstr("other.csv"));
  std::ofstream(path("bad.csv")) << CampaignRow::csvHeader() << "\n1,doors,x,5,dwa,both,goal,0,0"
                                 << ",,,,,,1,1,0\n";
  EXPECT_THAT(messageOf([&] { readRows(path("bad.csv")); }), HasSubstr("bad.csv row 1 seed"));
  std::ofstream(path("short.csv")) << CampaignRow::csvHeader() << "\n1,doors\n";
  EXPECT_THAT(messageOf([&] { readRows(path("short.csv")); }), HasSubstr("17 columns"));
}

TEST_F(RowFiles, ShardsMergeIntoTheOrderOfOneProcess) {
  for (long rank = 0; rank < 2; ++rank) {
    RowFile shard(shardFile(directory(), rank, 2));
    for (long i = rank; i < 5; i += 2) shard.append(sample(i));
  }
  mergeShards(directory(), 2);
  const auto rows = readRows(path("results.csv"));
  ASSERT_EQ(rows.size(), 5U);
  for (long i = 0; i < 5; ++i) EXPECT_EQ(rows[static_cast<std::size_t>(i)].encounter, i);
}

TEST_F(RowFiles, APlanIsKeptAndAnotherOneRefused) {
  keepPlan(directory(), "a\n");
  keepPlan(directory(), "a\n");
  EXPECT_THAT(messageOf([&] { keepPlan(directory(), "b\n"); }), HasSubstr("another campaign"));
}

}  // namespace
}  // namespace bslnav
