#include <bslnav/evaluation/PaperFigures.h>

#include <algorithm>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::hallCase;

/** Share of a picture's pixels in one colour. */
double shareOf(const Picture& picture, Colour colour) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) count += picture.pixel(x, y) == colour;
  return static_cast<double>(count) / picture.width / picture.height;
}

/** Runs of one case by some methods: noiseless and alike, but for their number. */
std::vector<NominalRun> runsBy(const std::vector<int>& methods) {
  std::vector<ExperimentCase> cases;
  cases.reserve(methods.size());
  for (const int method : methods) cases.push_back(hallCase("hall", method));
  return runNominal(cases, 1, 2);
}

TEST(CaseFigure, HasAPathAndARowOfCostMapsForEachMethod) {
  const Picture one = caseFigure(runsBy({1})), three = caseFigure(runsBy({1, 2, 4}));
  EXPECT_EQ(three.width, 1800);
  EXPECT_LE(one.width, 1800);
  // Two columns of 580 pixels at 4.6 m in 8 m are 330 high: two more rows of them.
  EXPECT_GT(three.height, one.height + 400);
  EXPECT_GT(shareOf(three, palette::kInscribed), 0.02);  // cost maps
  EXPECT_GT(shareOf(three, palette::kWall), 0.002);      // paths in the map
  EXPECT_GT(shareOf(three, palette::kWhite), 0.3);
}

TEST(CaseFigure, WithoutInstantsHasThePathsOnly) {
  auto entry = hallCase("hall", 1);
  entry.setup.pictures.snapshots_s.clear();
  const Picture figure = caseFigure(runNominal({entry}, 1, 1));
  EXPECT_EQ(shareOf(figure, palette::kInscribed), 0.0);
  EXPECT_GT(shareOf(figure, palette::kWall), 0.002);
}

TEST(CaseFigure, ARunThatEndedEarlyLeavesItsPlaceEmpty) {
  auto runs = runsBy({1, 2});
  const Picture complete = caseFigure(runs);
  runs[0].trace.snapshots.resize(1);
  const Picture shorter = caseFigure(runs);
  EXPECT_EQ(shorter.height, complete.height);  // the other keeps its columns
  EXPECT_LT(shareOf(shorter, palette::kInscribed), 0.8 * shareOf(complete, palette::kInscribed));
}

TEST(SpeedFigure, HasAPanelForSpeedAndOneForClearanceWherePeopleAre) {
  auto entry = hallCase("hall", 1);
  const Picture withPeople = speedFigure(runNominal({entry}, 1, 1));
  entry.setup.world.pedestrians.clear();
  const Picture alone = speedFigure(runNominal({entry}, 1, 1));
  EXPECT_EQ(withPeople.width, 1400);
  EXPECT_GT(withPeople.height, alone.height + 260);         // a panel of 260 pixels more
  EXPECT_GT(shareOf(withPeople, palette::kMagenta), 1e-5);  // the person starts
  EXPECT_EQ(shareOf(alone, palette::kMagenta), 0.0);
}

TEST(SpeedFigure, ShowsAContact) {
  auto runs = runsBy({1});
  const double before = shareOf(speedFigure(runs), palette::kRed);
  runs[0].summary.contact = true;
  EXPECT_EQ(before, 0.0);
  EXPECT_GT(shareOf(speedFigure(runs), palette::kRed), 1e-5);
}

}  // namespace
}  // namespace bslnav
