#include <bslnav/config/Error.h>
#include <bslnav/pictures/TimeChart.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

int pixelsOf(const Picture& picture, Colour colour) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) count += picture.pixel(x, y) == colour ? 1 : 0;
  return count;
}

/** Columns of the picture in which a colour occurs. */
int columnsOf(const Picture& picture, Colour colour) {
  int count = 0;
  for (int x = 0; x < picture.width; ++x) {
    bool found = false;
    for (int y = 0; y < picture.height; ++y) found |= picture.pixel(x, y) == colour;
    count += found ? 1 : 0;
  }
  return count;
}

TimeChart speedChart(const std::vector<double>& y, const SeriesStyle& style,
                     const std::string& label = "") {
  TimeChart chart("Title", "", "time [s]", 800, 200);
  chart.panel("speed [m/s]");
  std::vector<double> x(y.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
  chart.series(label, x, y, style);
  return chart;
}

const SeriesStyle kRedLine{SeriesStyle::Form::Line, palette::kRed, 4.0, false};

TEST(TimeChart, LineCrossesTheWholePanel) {
  const Picture page = speedChart({0.2, 0.5, 0.3}, kRedLine).finished();
  EXPECT_EQ(page.width, 800);
  // 800 less margins of 28 at both sides and 64 for the axis is 680.
  EXPECT_NEAR(columnsOf(page, palette::kRed), 680, 4);
}

TEST(TimeChart, ValuesThatAreNotFiniteLeaveAGap) {
  const Picture page = speedChart({0.2, 0.2, NAN, 0.2, 0.2}, kRedLine).finished();
  // Two of four intervals are drawn, half of 680 columns; round ends add a few.
  EXPECT_NEAR(columnsOf(page, palette::kRed), 340, 10);
}

TEST(TimeChart, StepsHoldAValueUntilTheNext) {
  const SeriesStyle steps{SeriesStyle::Form::Steps, palette::kRed, 4.0, false};
  const Picture page = speedChart({0.0, 1.0, 1.0}, steps).finished();
  // The line is either at 0, at 1 or vertical at x = 1, in the middle: at a quarter of the panel it
  // is still low.
  const int quarter = 28 + 64 + 170, threeQuarters = 28 + 64 + 510;
  int low = 0, high = 0;
  for (int y = 0; y < page.height; ++y) {
    if (page.pixel(quarter, y) == palette::kRed) low = y;
    if (page.pixel(threeQuarters, y) == palette::kRed) high = y;
  }
  // The range 0 to 1 takes 1/1.06 of the 200 rows.
  EXPECT_NEAR(low - high, 200.0 / 1.06, 1.5);
}

TEST(TimeChart, EachPanelAddsItsHeight) {
  TimeChart one("", "", "time [s]", 800, 200), two("", "", "time [s]", 800, 200);
  one.panel("a");
  two.panel("a");
  two.panel("b");
  EXPECT_GT(two.finished().height, one.finished().height + 200);
}

TEST(TimeChart, LabelAddsASwatch) {
  const int without = pixelsOf(speedChart({0.2, 0.5}, kRedLine).finished(), palette::kRed);
  const int with = pixelsOf(speedChart({0.2, 0.5}, kRedLine, "command").finished(), palette::kRed);
  EXPECT_GT(with, without + 60);  // a line of about 32 x 4 pixels
}

TEST(TimeChart, SpanLimitAndEventAreDrawn) {
  TimeChart chart = speedChart({0.2, 0.5, 0.3}, kRedLine);
  chart.span(0.5, 1.5, palette::kOrange, "");
  chart.limit(0.6, palette::kGreen, "");
  chart.event(0.5, "start");
  const Picture page = chart.finished();
  // Half of the 680 columns are shaded with a fifth of the colour over white.
  EXPECT_NEAR(columnsOf(page, mixed(palette::kWhite, palette::kOrange, 0.2)), 340, 8);
  EXPECT_GT(pixelsOf(page, palette::kGreen), 200);
  EXPECT_GT(pixelsOf(page, palette::kFaintInk), 100);
}

TEST(TimeChart, EmptyChartStillHasItsFrame) {
  TimeChart chart("", "", "time [s]", 800, 200);
  chart.panel("speed [m/s]");
  chart.series("nothing", {}, {});
  EXPECT_GT(pixelsOf(chart.finished(), palette::kFrame), 500);
}

TEST(TimeChart, SameCallsGiveTheSamePixels) {
  EXPECT_EQ(speedChart({0.2, 0.5, 0.3}, kRedLine, "a").finished().rgb,
            speedChart({0.2, 0.5, 0.3}, kRedLine, "a").finished().rgb);
}

TEST(TimeChart, MisuseIsAnError) {
  TimeChart chart("", "", "time [s]");
  EXPECT_THROW(chart.series("a", {0.0}, {0.0}), Error) << "before any panel";
  chart.panel("speed [m/s]");
  EXPECT_THROW(chart.series("a", {0.0, 1.0}, {0.0}), Error);
}

TEST(TimeChart, ImpossiblePathIsAnErrorOfTheRun) {
  try {
    speedChart({0.2}, kRedLine).save(testing::TempDir() + "no_such_directory/chart.png");
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Run);
  }
}

}  // namespace
}  // namespace bslnav
