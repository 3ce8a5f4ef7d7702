#include <bslnav/campaign/Campaign.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <gmock/gmock.h>

namespace bslnav {
namespace {

/** A robot with one laser that drives by the velocity window, Method 1. */
Entrant laserEntrant(const std::string& engine) {
  Entrant entrant{1, engine, "laser", {}, "[x]\n"};
  LaserParameters laser;
  laser.fov_rad = 2.0 * M_PI;
  laser.beams = 180;
  entrant.setup.lasers["all_round"] = laser;
  return entrant;
}

Campaign smallCampaign() {
  Campaign campaign;
  campaign.entrants = {laserEntrant("one"), laserEntrant("two")};
  campaign.entrants[1].setup.navigation.limits.maxSpeed_mps = 0.4;
  campaign.count = 3;
  campaign.emptyEvery = 2;
  return campaign;
}

std::vector<std::string> rowsOf(const Campaign& campaign, const Shard& shard, long done, int jobs) {
  std::vector<std::string> rows;
  runShard(campaign, shard, done, jobs,
           [&rows](const CampaignRow& row) { rows.push_back(row.csv()); });
  return rows;
}

TEST(Campaign, EveryEntrantMeetsTheSamePeople) {
  const Campaign campaign = smallCampaign();
  const CampaignRow one = runOne(campaign, 4), two = runOne(campaign, 5);
  EXPECT_EQ(one.encounter, 2);
  EXPECT_EQ(two.encounter, 2);
  EXPECT_EQ(one.engine, "one");
  EXPECT_EQ(two.engine, "two");
  EXPECT_EQ(one.family, two.family);
  EXPECT_EQ(one.seed, two.seed);
}

TEST(Campaign, DrivesSomeEncountersWithNobodyThere) {
  const Campaign campaign = smallCampaign();
  const CampaignRow first = runOne(campaign, 1);
  ASSERT_TRUE(first.timeEmpty_s);
  EXPECT_GT(*first.timeEmpty_s, 7.0 / 0.4);  // 7.5 m at 0.4 m/s, the tolerance, and the start
  EXPECT_FALSE(runOne(campaign, 2).timeEmpty_s);
  ASSERT_TRUE(first.yardstick_s);  // encounter 0 is one of a one-sided opening
  EXPECT_GT(*first.timeEmpty_s, 0.9 * *first.yardstick_s);
}

TEST(Campaign, RowsDependNeitherOnJobsNorOnHowTheyAreSharedOutNorOnStopping) {
  const Campaign campaign = smallCampaign();
  const auto all = rowsOf(campaign, {}, 0, 1);
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(rowsOf(campaign, {}, 0, 3), all);
  const auto later = rowsOf(campaign, {}, 4, 2);
  EXPECT_EQ(later, std::vector<std::string>(all.begin() + 4, all.end()));
  const auto even = rowsOf(campaign, {0, 2}, 0, 1), odd = rowsOf(campaign, {1, 2}, 0, 1);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ((i % 2 == 0 ? even : odd)[i / 2], all[i]);
}

TEST(Campaign, NothingIsLeftOfAFinishedOne) {
  const Campaign campaign = smallCampaign();
  EXPECT_TRUE(rowsOf(campaign, {}, 6, 1).empty());
  EXPECT_TRUE(rowsOf(campaign, {}, 9, 1).empty());
}

TEST(Campaign, ThePlanTellsEntrantsApartButNotTheNumberOfEncounters) {
  Campaign campaign = smallCampaign();
  const std::string plan = campaign.plan();
  campaign.count = 50;
  EXPECT_EQ(campaign.plan(), plan);
  campaign.entrants[0].configuration = "[y]\n";
  EXPECT_NE(campaign.plan(), plan);
}

}  // namespace
}  // namespace bslnav
