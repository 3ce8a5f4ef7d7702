#include <gmock/gmock.h>
#include <mrpt/core/Clock.h>

#include <memory>
#include <thread>
#include <vector>

#include "TextBaseRig.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Wire = TextBaseEmulator::Wire;

class TextBaseFaultsOver : public testing::TestWithParam<Wire> {
 protected:
  bool hearsMore(TextBase& base, int states = 3) {
    const int before = base.counts().states;
    return eventually([&] { return base.counts().states >= before + states; });
  }

  TextBaseEmulator emulator_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Wires, TextBaseFaultsOver, testing::Values(Wire::Serial, Wire::Tcp),
                         [](const auto& wire) {
                           return wire.param == Wire::Serial ? "Serial" : "Tcp";
                         });

TEST_P(TextBaseFaultsOver, TellsThatTheLineIsGone) {
  TextBase base(at(emulator_.address()));
  emulator_.pullCable();
  EXPECT_TRUE(eventually([&] { return !errorOf([&] { base.state(); }).empty(); }));
  const auto named = AllOf(HasSubstr(emulator_.address()), HasSubstr("the line is gone"));
  EXPECT_THAT(errorOf([&] { base.state(); }), named);
  EXPECT_THAT(errorOf([&] { base.drive({0.1, 0.0, 0.0}); }), named);
  base.stop();
}

TEST_P(TextBaseFaultsOver, DropsAndCountsGarbage) {
  TextBase base(at(emulator_.address()));
  const int before = base.counts().refused;
  emulator_.send(std::string("\n\xff\x00\x80$*\n$S,1,9,9,9,0,0,0*00\nstarting...\n", 39));
  EXPECT_TRUE(eventually([&] { return base.counts().refused == before + 3; }));
  EXPECT_TRUE(hearsMore(base));
  EXPECT_EQ(base.counts().refused, before + 3);
  EXPECT_EQ(base.state().odometry.x, 0.0);
}

// The half line spoils the one that follows without a line feed between, and nothing else.
TEST_P(TextBaseFaultsOver, DropsHalfALine) {
  TextBase base(at(emulator_.address()));
  const int before = base.counts().refused;
  emulator_.send("$S,1,9.0000,9.0");
  EXPECT_TRUE(eventually([&] { return base.counts().refused == before + 1; }));
  EXPECT_TRUE(hearsMore(base));
  EXPECT_EQ(base.state().odometry.x, 0.0);
}

TEST_P(TextBaseFaultsOver, PassesNoNanOn) {
  TextBase base(at(emulator_.address()));
  emulator_.tellNan(true);
  const int before = base.counts().refused;
  EXPECT_TRUE(eventually([&] { return base.counts().refused > before + 3; }));
  EXPECT_EQ(base.state().odometry.x, 0.0);
  emulator_.tellNan(false);
  EXPECT_TRUE(hearsMore(base));
}

TEST_P(TextBaseFaultsOver, LetsTheStampTellThatTheBaseIsSilent) {
  TextBase base(at(emulator_.address()));
  emulator_.beSilent(true);
  EXPECT_TRUE(eventually([&] { return mrpt::Clock::nowDouble() - base.state().stamp_s > 0.3; }));
  emulator_.beSilent(false);
  EXPECT_TRUE(eventually([&] { return mrpt::Clock::nowDouble() - base.state().stamp_s < 0.1; }));
}

TEST_P(TextBaseFaultsOver, HearsNothingMoreFromABaseThatBeganAnew) {
  TextBase base(at(emulator_.address()));
  base.drive({0.5, 0.0, 0.0});
  emulator_.restart();
  EXPECT_TRUE(eventually([&] { return mrpt::Clock::nowDouble() - base.state().stamp_s > 0.2; }));
  base.drive({0.5, 0.0, 0.0});
  EXPECT_TRUE(eventually([&] { return emulator_.refused() > 0; }));
  EXPECT_EQ(emulator_.command().vx, 0.0);
}

TEST_P(TextBaseFaultsOver, StampsWhenTheBasesClockJumps) {
  TextBase base(at(emulator_.address()));
  for (const double jump_s : {100.0, -50.0, -0.5, 1e5}) {
    emulator_.jumpClock(jump_s);
    EXPECT_TRUE(hearsMore(base));
    // Since the jump's line: now; a busy machine may have held up any that followed.
    EXPECT_TRUE(eventually([&] {
      const double stamp_s = base.state().stamp_s, now_s = mrpt::Clock::nowDouble();
      EXPECT_LE(stamp_s, now_s);
      return now_s - stamp_s < 0.1;
    })) << jump_s;
  }
}

// Nobody reads: the line fills up, a command fails within 50 ms, and so does a stop.
TEST_P(TextBaseFaultsOver, ABaseThatTakesNothingHoldsNobodyUp) {
  auto base = std::make_unique<TextBase>(at(emulator_.address()));
  emulator_.beDeaf(true);
  std::string error;
  for (int i = 0; i < 1000000 && error.empty(); ++i)
    error = errorOf([&] { base->drive({0.1, 0.0, 0.0}); });
  EXPECT_THAT(error, HasSubstr("takes no more lines"));
  EXPECT_LT(secondsOf([&] { base->stop(); }), 0.5);
  EXPECT_LT(secondsOf([&] { base.reset(); }), 1.0);
  emulator_.beDeaf(false);
}

TEST(TextBaseFaults, StopsFromAnyThreadWhileOthersDrive) {
  TextBaseEmulator emulator;
  TextBase base(at(emulator.address()));
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i)
    threads.emplace_back([&base, i] {
      for (int n = 0; n < 50; ++n) {
        if (i == 0) base.stop();
        if (i == 1) base.drive({0.2, 0.0, 0.0});
        if (i == 2) base.state();
      }
    });
  for (auto& thread : threads) thread.join();
  base.stop();
  EXPECT_TRUE(eventually([&] { return emulator.stopped(); }));
  EXPECT_EQ(emulator.refused(), 0);
}

}  // namespace
}  // namespace bslnav::test
