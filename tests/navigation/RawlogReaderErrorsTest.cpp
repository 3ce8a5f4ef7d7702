#include <bslnav/config/Error.h>
#include <bslnav/navigation/RawlogReader.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing_logs::LogWriter;
using testing_logs::read;

std::string writeText(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "bslnav_" + name + ".rawlog";
  std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
  return path;
}

/** Expects that reading `file` is refused with `kind` and a text that names the file and says
 * `problem`. */
void expectRefused(const std::string& file, Error::Kind kind, const std::string& problem) {
  try {
    RawlogReader reader(file);
    FAIL() << file << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    EXPECT_THAT(error.what(), AllOf(HasSubstr(file), HasSubstr(problem)));
  }
}

/** Ten scans: records 0 to 9. */
std::string tenScans(const std::string& name, int compression) {
  LogWriter writer(name, compression);
  for (int i = 0; i < 10; ++i) writer.scan(0.1 * i);
  return writer.close();
}

TEST(RawlogReaderErrors, RefusesAMissingFile) {
  expectRefused("/nowhere/log.rawlog", Error::Kind::Configuration, "no such file");
}

TEST(RawlogReaderErrors, RefusesADirectory) {
  expectRefused(testing::TempDir(), Error::Kind::Configuration, "expected a rawlog");
}

TEST(RawlogReaderErrors, RefusesAnEmptyFile) {
  expectRefused(writeText("empty", ""), Error::Kind::Run, "is empty");
}

TEST(RawlogReaderErrors, RefusesText) {
  expectRefused(writeText("text", "[robot]\nradius_m = 0.3\n"), Error::Kind::Run,
                "is not a rawlog");
}

TEST(RawlogReaderErrors, RefusesALogWithoutScansAndDepth) {
  const auto file = LogWriter("no_scans").odometry(0.0, {}).odometry(0.1, {}).close();
  expectRefused(file, Error::Kind::Run, "neither a 2D laser scan nor a depth frame in 2 records");
}

TEST(RawlogReaderErrors, RefusesALogWhoseOnlyDepthHasNoRangeImage) {
  auto empty = testing_logs::makeDepth(0.0);
  empty.hasRangeImage = false;
  const auto file = LogWriter("no_range_image").odometry(0.0, {}).add(empty).add(empty).close();
  expectRefused(file, Error::Kind::Run,
                "none of its 2 depth frames has a range image; the first: record 1");
}

TEST(RawlogReaderErrors, RefusesALogCutInItsFirstRecord) {
  const auto file = tenScans("cut_first", 0);
  std::filesystem::resize_file(file, 40);
  expectRefused(file, Error::Kind::Run, "is not a rawlog");
}

TEST(RawlogReaderErrors, ReadsACutLogUpToTheCut) {
  // Ten equal records: 9.5 of them leave nine whole ones, 0 to 8, and half of record 9.
  const auto file = tenScans("cut", 0);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 19 / 20);
  const auto statistics = read(file).statistics;
  EXPECT_EQ(statistics.frames, 9u);
  EXPECT_TRUE(statistics.truncated);
  EXPECT_EQ(statistics.truncatedAtRecord, 9u);
}

TEST(RawlogReaderErrors, ReadsACutLogWithDepthUpToTheCut) {
  // As above: nine whole records, and half of record 9.
  LogWriter writer("cut_depth", 0);
  for (int i = 0; i < 10; ++i) writer.depth(0.1 * i);
  const auto file = writer.close();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 19 / 20);
  const auto statistics = read(file).statistics;
  EXPECT_EQ(statistics.depthFrames, 9u);
  EXPECT_TRUE(statistics.truncated);
  EXPECT_EQ(statistics.truncatedAtRecord, 9u);
}

TEST(RawlogReaderErrors, ReadsACutCompressedLogUpToTheCut) {
  LogWriter writer("cut_compressed");
  for (int i = 0; i < 1000; ++i) writer.scan(0.1 * i);
  const auto file = writer.close();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const auto statistics = read(file).statistics;
  EXPECT_TRUE(statistics.truncated);
  EXPECT_GT(statistics.frames, 100u);
  EXPECT_LT(statistics.frames, 900u);
  EXPECT_EQ(statistics.truncatedAtRecord, statistics.frames);
}

TEST(RawlogReaderErrors, TakesAWholeLogForWhole) {
  for (const int compression : {0, 1}) {
    const auto statistics = read(tenScans("whole", compression)).statistics;
    EXPECT_EQ(statistics.frames, 10u);
    EXPECT_FALSE(statistics.truncated);
  }
}

}  // namespace
}  // namespace bslnav
