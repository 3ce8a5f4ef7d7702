#include <bslnav/evaluation/RunMemory.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "EvaluationRig.h"

namespace bslnav::test {
namespace {

using testing::StartsWith;

TEST(ResidentMemory, GrowsWithWhatIsUsed) {
  const double before_MB = residentMemory_MB(::getpid());
  const std::vector<char> used(64'000'000, 'x');
  EXPECT_NEAR(residentMemory_MB(::getpid()) - before_MB, 64.0, 4.0);
}

TEST(ResidentMemory, IsNoNumberOfAProcessThatIsNotThere) {
  EXPECT_TRUE(std::isnan(residentMemory_MB(-1)));
}

/** Samples are due at 0, 2 and 4 s, the robot having gone 0, 1 and 2 m. */
TEST(RunMemory, IsSampledAfterEachPeriodBesideTheWay) {
  const std::string directory = testing::TempDir() + "run_memory";
  std::filesystem::create_directories(directory);
  RunMemory memory(directory, 2.0);
  for (int second = 0; second <= 5; ++second)
    memory.observe(second, {0.5 * second, 1.0}, [] {
      return std::vector<RunMemory::Program>{{"bslnav", ::getpid()}, {"laser", -1}};
    });
  const auto lines = linesOf(directory + "/memory.csv");
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[0], "time_s,driven_m,program,resident_mb");
  EXPECT_THAT(lines[1], StartsWith("0.0,0.00,bslnav,"));
  EXPECT_EQ(lines[2], "0.0,0.00,laser,nan");
  EXPECT_THAT(lines[3], StartsWith("2.0,1.00,bslnav,"));
  EXPECT_THAT(lines[5], StartsWith("4.0,2.00,bslnav,"));
  EXPECT_THAT(textOf(memory.save("Memory")), StartsWith("\x89PNG"));
}

TEST(RunMemory, TellsOfADirectoryThatIsNotThere) {
  EXPECT_THAT(errorOf([] { RunMemory("/no/such/place", 1.0); }),
              StartsWith("/no/such/place/memory.csv"));
}

}  // namespace
}  // namespace bslnav::test
