#include <filesystem>
#include <set>

#include "AppTest.h"

namespace bslnav::test {
namespace {

class Repeatability : public AppTest {
 protected:
  void SetUp() override { ASSERT_EQ(drive(kS1, {"--method", "2"}, "first").exitCode, 0); }

  std::set<std::string> files(const std::string& name) const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path(name)))
      names.insert(entry.path().filename());
    return names;
  }
};

TEST_F(Repeatability, TheSameCommandGivesTheSameBytes) {
  ASSERT_EQ(drive(kS1, {"--method", "2"}, "second").exitCode, 0);
  EXPECT_EQ(files("first"), files("second"));
  for (const auto& file : files("first")) {
    if (file == "summary.json") continue;
    EXPECT_TRUE(readFile(out(file, "first")) == readFile(out(file, "second"))) << file;
  }
  EXPECT_EQ(withoutTimings(summary("first")), withoutTimings(summary("second")));
}

/** MRPT's engine asks the wall clock for its statistics; commands must not depend on it. */
TEST_F(Repeatability, TheSameCommandGivesTheSameBytesWithMrptsEngine) {
  for (const char* engine : {"ptg", "mrpt"}) {
    for (const char* name : {"a", "b"})
      ASSERT_EQ(
          drive(kS1, {"--method", "2", "--navigator", engine, "--set", "scenario.time_limit_s=8"},
                std::string(engine) + name)
              .exitCode,
          1);  // out of time
    EXPECT_EQ(readFile(out("cycles.csv", std::string(engine) + "a")),
              readFile(out("cycles.csv", std::string(engine) + "b")));
  }
  EXPECT_NE(readFile(out("cycles.csv", "ptga")), readFile(out("cycles.csv", "mrpta")));
}

TEST_F(Repeatability, TheEffectiveConfigurationGivesTheSameRun) {
  ASSERT_EQ(drive(out("config.ini", "first"), {}, "second").exitCode, 0);
  EXPECT_EQ(readFile(out("cycles.csv", "first")), readFile(out("cycles.csv", "second")));
  EXPECT_EQ(readFile(out("config.ini", "first")), readFile(out("config.ini", "second")));
}

TEST_F(Repeatability, AnotherSeedGivesAnotherNoise) {
  drive(kS1, {"--method", "2", "--seed", "2"}, "second");
  EXPECT_NE(readFile(out("cycles.csv", "first")), readFile(out("cycles.csv", "second")));
  EXPECT_EQ(readFile(out("config.ini", "first")), readFile(out("config.ini", "second")));
}

}  // namespace
}  // namespace bslnav::test
