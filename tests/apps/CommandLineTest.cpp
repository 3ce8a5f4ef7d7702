#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class CommandLine : public AppTest {};

TEST_F(CommandLine, HelpShowsAnExample) {
  const AppResult result = run({"--help"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.out, HasSubstr("Example:\n  bslnav config/scenarios/s1.ini"));
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(CommandLine, VersionIsTheProjects) {
  const AppResult result = run({"--version"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, BSLNAV_TEST_VERSION "\n");
}

TEST_F(CommandLine, WithoutConfigurationSaysWhatIsExpected) {
  const AppResult result = run({});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err, HasSubstr("expected bslnav CONFIG.ini"));
}

TEST_F(CommandLine, UnknownOptionIsRefused) {
  const AppResult result = run({kS1, "--fast"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, HasSubstr("--fast"));
}

TEST_F(CommandLine, ValuesThatAreNoNumbersAreRefused) {
  for (const Arguments& bad : {Arguments{"--method", "two"}, {"--seed", "1.5"}, {"--seed", "-1"}}) {
    const AppResult result = drive(write("room.ini", kRoom), bad);
    EXPECT_EQ(result.exitCode, 2) << bad[1];
    EXPECT_THAT(result.err, HasSubstr(bad[0])) << bad[1];
    EXPECT_FALSE(exists(path("out"))) << bad[1];
  }
}

TEST_F(CommandLine, PrintedConfigurationIsOneThatPrintsTheSame) {
  const AppResult first = run({kS1, "--method", "2", "--print-config"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("\nsource = scan_jumps\n"));
  const AppResult second = run({write("printed.ini", first.out), "--print-config"});
  EXPECT_EQ(second.exitCode, 0) << second.err;
  EXPECT_EQ(second.out, first.out);
}

TEST_F(CommandLine, PrintingTheConfigurationDrivesNothing) {
  ASSERT_EQ(drive(kS1, {"--print-config"}).exitCode, 0);
  EXPECT_FALSE(exists(path("out")));
}

TEST_F(CommandLine, MethodIsShortForItsOverlayAfterTheFiles) {
  const std::string overlay = BSLNAV_SOURCE_DIR "/config/methods/method2.ini";
  EXPECT_EQ(run({kS1, "--method", "2", "--print-config"}).out,
            run({kS1, overlay, "--print-config"}).out);
}

TEST_F(CommandLine, OverridesComeAfterTheMethod) {
  const AppResult result = run({kS1, "--method", "2", "--set", "blind_spots.source=none", "--set",
                                "scenario.time_limit_s=7.5", "--print-config"});
  EXPECT_THAT(result.out, HasSubstr("\nsource = none\n"));
  EXPECT_THAT(result.out, HasSubstr("\ntime_limit_s = 7.5\n"));
}

TEST_F(CommandLine, LaterFilesOverrideEarlierOnes) {
  const std::string more = write("more.ini", "[scenario]\nname = mine\n");
  EXPECT_THAT(run({kS1, more, "--print-config"}).out, HasSubstr("\nname = mine\n"));
  EXPECT_THAT(run({more, kS1, "--print-config"}).out, HasSubstr("\nname = S1\n"));
}

}  // namespace
}  // namespace bslnav::test
