#include <bslnav/evaluation/PaperFigures.h>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::hallCase;

/** How many of a picture's pixels have one colour. */
int countOf(const Picture& picture, Colour colour) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) count += picture.pixel(x, y) == colour;
  return count;
}

/** Runs of one case by some methods: noiseless and alike, but for their number. */
std::vector<NominalRun> runsBy(const std::vector<int>& methods) {
  std::vector<ExperimentCase> cases;
  cases.reserve(methods.size());
  for (const int method : methods) cases.push_back(hallCase("hall", method));
  return runNominal(cases, 1, 2);
}

TEST(CaseFigure, HasAPathAndARowOfCostMapsForEachMethod) {
  const Picture one = caseFigure(runsBy({1})), two = caseFigure(runsBy({1, 4}));
  EXPECT_LE(one.width, 1800);
  EXPECT_EQ(two.width, 1800);
  EXPECT_GT(countOf(one, palette::kWall), 1000);  // the map under the paths
  // Both drive alike and have tiles of one size: twice the cost maps, but for the one legend.
  const double ratio =
      double(countOf(two, palette::kInscribed)) / countOf(one, palette::kInscribed);
  EXPECT_NEAR(ratio, 2.0, 0.05);
}

TEST(CaseFigure, WithoutInstantsHasThePathsOnly) {
  auto entry = hallCase("hall", 1);
  entry.setup.pictures.snapshots_s.clear();
  const Picture figure = caseFigure(runNominal({entry}, 1, 1));
  EXPECT_EQ(countOf(figure, palette::kInscribed), 0);
  EXPECT_GT(countOf(figure, palette::kWall), 1000);
}

TEST(CaseFigure, ARunThatEndedEarlyLeavesItsPlaceEmpty) {
  auto runs = runsBy({1, 2});
  const Picture complete = caseFigure(runs);
  runs[0].trace.snapshots.resize(1);
  const Picture shorter = caseFigure(runs);
  EXPECT_EQ(shorter.height, complete.height);  // the other run keeps its columns
  // Three cost maps of four are left.
  const double ratio =
      double(countOf(shorter, palette::kInscribed)) / countOf(complete, palette::kInscribed);
  EXPECT_NEAR(ratio, 0.75, 0.05);
}

TEST(SpeedFigure, HasAPanelForSpeedAndOneForClearanceWherePeopleAre) {
  auto entry = hallCase("hall", 1);
  const Picture withPeople = speedFigure(runNominal({entry}, 1, 1));
  entry.setup.world.pedestrians.clear();
  const Picture alone = speedFigure(runNominal({entry}, 1, 1));
  EXPECT_EQ(withPeople.width, 1400);
  EXPECT_GT(withPeople.height, alone.height + 260);       // a panel of 260 pixels more
  EXPECT_GT(countOf(withPeople, palette::kMagenta), 20);  // the person starts
  EXPECT_EQ(countOf(alone, palette::kMagenta), 0);
}

TEST(SpeedFigure, ShowsAContact) {
  auto runs = runsBy({1});
  const int before = countOf(speedFigure(runs), palette::kRed);
  runs[0].summary.contact = true;
  EXPECT_EQ(before, 0);
  EXPECT_GT(countOf(speedFigure(runs), palette::kRed), 20);
}

}  // namespace
}  // namespace bslnav
