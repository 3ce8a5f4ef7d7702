#include <bslnav/campaign/CampaignResults.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace bslnav {
namespace {

using testing::HasSubstr;

CampaignRow row(int method, const std::string& outcome, std::optional<double> time_s) {
  CampaignRow row;
  row.family = "doors";
  row.method = method;
  row.engine = "dwa";
  row.sensors = "both";
  row.outcome = outcome;
  row.timeToGoal_s = time_s;
  row.minClearance_m = 0.5;
  return row;
}

CampaignRow contact(int method, bool atFault) {
  CampaignRow touched = row(method, "contact", {});
  touched.contact = true;
  touched.atFault = atFault;
  touched.impactSpeed_mps = atFault ? 0.4 : 0.0;
  touched.minClearance_m = -0.01;
  return touched;
}

TEST(Wilson, IsTheScoreInterval) {
  // Newcombe (1998): 81 of 263 gives 0.2553 to 0.3662.
  const Share share = wilson(81, 263);
  EXPECT_NEAR(share.low, 0.2553, 1e-4);
  EXPECT_NEAR(share.high, 0.3662, 1e-4);
  EXPECT_NEAR(share.share, 81.0 / 263.0, 1e-12);
}

TEST(Wilson, HoldsForRareEvents) {
  const Share none = wilson(0, 5000);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.000768, 1e-6);  // z² / (n + z²)
  EXPECT_EQ(wilson(0, 0).high, 1.0);
}

class Results : public testing::Test {
 protected:
  std::vector<CampaignRow> rows_{row(1, "goal", 20.0), row(5, "goal", 24.0), contact(1, true),
                                 row(5, "goal", 26.0), row(1, "stuck", {}),  contact(5, false)};
};

TEST_F(Results, AddUpByEntrant) {
  rows_[1].lapse_s = 0.3;
  rows_[3].timeEmpty_s = 21.0;
  rows_[3].yardstick_s = 20.0;
  const auto results = resultsOf(rows_);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].name(), "Method 1, dwa, both");
  EXPECT_EQ(results[0].encounters, 3);
  EXPECT_EQ(results[0].goals, 1);
  EXPECT_EQ(results[0].atFault, 1);
  EXPECT_DOUBLE_EQ(results[0].goalShareWithoutContact(), 0.5);
  EXPECT_THAT(results[0].impacts_mps, testing::ElementsAre(0.4));
  EXPECT_EQ(results[1].contacts, 1);
  EXPECT_EQ(results[1].atFault, 0);
  EXPECT_EQ(results[1].lapsed, 1);
  EXPECT_THAT(results[1].times_s, testing::ElementsAre(24.0, 26.0));
  EXPECT_THAT(results[1].emptyTimes_s, testing::ElementsAre(21.0));
  EXPECT_THAT(results[1].toYardstick, testing::ElementsAre(21.0 / 20.0));
  EXPECT_THAT(campaignTables(results), HasSubstr("- Method 5, dwa, both: 1.050 (1 openings)"));
  EXPECT_THAT(results[1].clearances_m, testing::ElementsAre(0.5, 0.5, 0.0));
  EXPECT_EQ(results[1].families.at("doors"), std::make_pair(1L, 0L));
}

TEST_F(Results, TablesAndJsonSayTheSame) {
  const auto results = resultsOf(rows_);
  const std::string tables = campaignTables(results);
  EXPECT_THAT(tables, HasSubstr("| 5 | dwa | both | 3 | 66.7 | 100.0 | 1 | 0 | 0.00 to 56.15 |"));
  EXPECT_THAT(tables, HasSubstr("| 1 | dwa | both | 1 (1) |"));
  const auto json = nlohmann::json::parse(campaignJson(results));
  EXPECT_EQ(json[1]["method"], 5);
  EXPECT_DOUBLE_EQ(json[1]["time_to_goal_mean_s"], 25.0);
  EXPECT_EQ(json[0]["families"]["doors"]["at_fault"], 1);
}

TEST_F(Results, FiguresAreDrawn) {
  const std::string directory = testing::TempDir();
  for (const auto& path : saveCampaignFigures(resultsOf(rows_), directory))
    EXPECT_GT(std::filesystem::file_size(path), 1000U) << path;
}

}  // namespace
}  // namespace bslnav
