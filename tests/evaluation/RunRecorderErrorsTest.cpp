#include "RunRecorderFixture.h"

namespace bslnav {
namespace {

namespace fs = std::filesystem;
using test::errorOf;
using test::RunRecorderTest;

TEST_F(RunRecorderTest, DirectoryThatCannotBeMadeIsAnErrorOfTheRun) {
  fs::create_directories(fs::path(directory).parent_path());
  std::ofstream(directory) << "a file stands in the way";
  try {
    RunRecorder recorder(directory, config);
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Run);
    EXPECT_THAT(error.what(), testing::HasSubstr(directory));
  }
}

/** A full disk: the file is /dev/full. */
class FullDiskTest : public RunRecorderTest {
 protected:
  void SetUp() override {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    fs::create_directories(directory);
  }
  void fill(const std::string& file) const {
    fs::create_symlink("/dev/full", directory + "/" + file);
  }
};

TEST_F(FullDiskTest, ConfigurationThatDoesNotFitIsAnErrorNamingTheFile) {
  fill("config.ini");
  EXPECT_THAT(errorOf([&] { RunRecorder recorder(directory, config); }),
              testing::HasSubstr("config.ini"));
}

TEST_F(FullDiskTest, CyclesThatDoNotFitAreAnErrorNamingTheFile) {
  fill("cycles.csv");
  RunRecorder recorder(directory, config);
  EXPECT_THAT(errorOf([&] { recorder.write({}, {}); }), testing::HasSubstr("cycles.csv"));
}

TEST_F(FullDiskTest, CandidatesThatDoNotFitAreAnErrorNamingTheFile) {
  fill("candidates.csv");
  RunRecorder recorder(directory, config);
  recorder.recordCandidates();
  EXPECT_THAT(errorOf([&] { recorder.finish({}); }), testing::HasSubstr("candidates.csv"));
}

TEST_F(FullDiskTest, SummaryThatDoesNotFitIsAnErrorNamingTheFile) {
  fill("summary.json");
  RunRecorder recorder(directory, config);
  EXPECT_THAT(errorOf([&] { recorder.finish({}); }), testing::HasSubstr("summary.json"));
}

}  // namespace
}  // namespace bslnav
