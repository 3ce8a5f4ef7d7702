#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const char* const kLog = "/usr/share/mrpt/datasets/localization_demo.rawlog";
const char* const kConfig = BSLNAV_SOURCE_DIR "/config/rawlog.ini";
const char* const kDemo = BSLNAV_SOURCE_DIR "/config/rawlog-localization-demo.ini";

/** MRPT's localisation demo: 37 scans, each with an odometry action before it. */
class RawlogApp : public AppTest {
 protected:
  void SetUp() override {
    if (!exists(kLog)) GTEST_SKIP() << kLog << " is missing: it is in Debian's mrpt-common";
  }

  AppResult evaluate(Arguments arguments, const std::string& name = "out") const {
    arguments.insert(arguments.begin(), kConfig);
    arguments.insert(arguments.end(), {"--out", path(name)});
    return run(arguments, "bslnav-rawlog");
  }
};

TEST_F(RawlogApp, EvaluatesEveryScanInTheMap) {
  const AppResult result = evaluate({kDemo});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_EQ(summary()["cycles"], 37);
  EXPECT_EQ(rowsOf(out("cycles.csv")), 37U);
  EXPECT_EQ(summary()["rawlog"]["truncated_at_record"], nullptr);
  for (const char* picture : {"path.png", "comparison.png"})
    EXPECT_THAT(readFile(out(picture)), StartsWith("\x89PNG")) << picture;
}

TEST_F(RawlogApp, TheSameCommandGivesTheSameBytes) {
  ASSERT_EQ(evaluate({kDemo}, "first").exitCode, 0);
  ASSERT_EQ(evaluate({kDemo}, "second").exitCode, 0);
  for (const char* file : {"config.ini", "cycles.csv", "path.png", "comparison.png"})
    EXPECT_TRUE(readFile(out(file, "first")) == readFile(out(file, "second"))) << file;
  EXPECT_EQ(withoutTimings(summary("first")), withoutTimings(summary("second")));
}

TEST_F(RawlogApp, EvaluatesALogOfDepthFramesOnly) {
  const std::string log = BSLNAV_SHARED_DATA "/depth/five_people_depth.rawlog";
  if (!exists(log)) GTEST_SKIP() << log << " is not here";
  const AppResult result = evaluate({"--rawlog", log});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("0.0 s, 0.0 m, 1 depth frame\n"));
  EXPECT_EQ(summary()["cycles"], 1);
  EXPECT_EQ(summary()["rawlog"]["depth_frames"], 1);
  EXPECT_EQ(summary()["rawlog"]["scans"], 0);
  for (const char* picture : {"path.png", "comparison.png"})
    EXPECT_THAT(readFile(out(picture)), StartsWith("\x89PNG")) << picture;
}

TEST_F(RawlogApp, ATruncatedLogIsEvaluatedUpToThereWithAWarning) {
  const std::string whole = readFile(kLog);
  const std::string cut = write("cut.rawlog", whole.substr(0, whole.size() * 2 / 3));
  const AppResult result = evaluate({"--rawlog", cut});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("truncated"));
  EXPECT_TRUE(summary()["rawlog"]["truncated_at_record"].is_number());
  // about two thirds of the 37 scans
  EXPECT_GT(summary()["cycles"], 20);
  EXPECT_LT(summary()["cycles"], 30);
}

TEST_F(RawlogApp, RefusesAnEmptyFile) {
  const std::string file = write("empty.rawlog", "");
  const AppResult result = evaluate({"--rawlog", file});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr(file + ": is empty; expected a rawlog"));
}

TEST_F(RawlogApp, RefusesAFileThatIsNoRawlog) {
  const std::string file = write("text.rawlog", "this is no rawlog");
  const AppResult result = evaluate({"--rawlog", file});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr(file + ": is not a rawlog"));
}

TEST_F(RawlogApp, RefusesALogWithoutScansAndDepth) {
  const AppResult result = evaluate({"--rawlog", "/usr/share/mrpt/datasets/kf-slam_demo.rawlog"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("neither a 2D laser scan nor a depth frame"));
}

TEST_F(RawlogApp, RefusesMissingFiles) {
  const AppResult log = evaluate({"--rawlog", "/no/such.rawlog"});
  EXPECT_EQ(log.exitCode, 2);
  EXPECT_THAT(log.err, HasSubstr("/no/such.rawlog: no such file"));
  const AppResult map = evaluate({"--rawlog", kLog, "--map", "/no/such.yaml"});
  EXPECT_EQ(map.exitCode, 2);
  EXPECT_THAT(map.err, HasSubstr("/no/such.yaml: no such file"));
  const AppResult none = evaluate({});
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, HasSubstr("--rawlog FILE"));
}

TEST_F(RawlogApp, RefusesToLocaliseInAMapThatIsNotThere) {
  const AppResult result =
      evaluate({"--rawlog", kLog, "--set", "localization.source=particle_filter"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("[rawlog] map"));
}

TEST_F(RawlogApp, PrintedConfigurationIsOneThatPrintsTheSame) {
  const AppResult first = evaluate({kDemo, "--print-config"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const AppResult second =
      run({write("printed.ini", first.out), "--print-config"}, "bslnav-rawlog");
  EXPECT_EQ(second.exitCode, 0) << second.err;
  EXPECT_EQ(second.out, first.out);
}

}  // namespace
}  // namespace bslnav::test
