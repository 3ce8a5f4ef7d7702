#include <bslnav/config/Error.h>
#include <bslnav/hardware/Keeper.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <fstream>
#include <iterator>

#include "ChildProcess.h"
#include "CreateRig.h"

namespace bslnav::test {
namespace {

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/** An empty file. */
std::string fileOf(const std::string& test) {
  const std::string path = testing::TempDir() + "/bslnav_keeper_" + test;
  std::ofstream file(path, std::ios::trunc);
  return path;
}

/** Ends a process with a Keeper by a signal to it and its group. */
void expectLastWordsAfter(int signal, const std::string& file) {
  const std::string ready = fileOf("ready");
  ChildProcess process([&] {
    const Keeper keeper(file, "last words");
    std::ofstream(ready) << "!";
    for (;;) ::pause();
  });
  ASSERT_TRUE(eventually([&] { return contentOf(ready) == "!"; }));
  EXPECT_EQ(contentOf(file), "");
  process.end(signal);
  EXPECT_TRUE(eventually([&] { return contentOf(file) == "last words"; }));
}

TEST(Keeper, WritesWhenItGoes) {
  const std::string file = fileOf("goes");
  {
    const Keeper keeper(file, "last words");
    EXPECT_EQ(contentOf(file), "");
  }
  EXPECT_EQ(contentOf(file), "last words");
}

TEST(Keeper, WritesWhenItsProcessIsKilled) { expectLastWordsAfter(SIGKILL, fileOf("killed")); }

TEST(Keeper, OutlivesTheCtrlCThatEndsItsProcess) {
  expectLastWordsAfter(SIGINT, fileOf("interrupted"));
}

TEST(Keeper, HoldsNothingElseOpen) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const Keeper keeper(fileOf("holds"), "last words");
  ::close(pipe[1]);
  pollfd waited{pipe[0], POLLIN, 0};
  EXPECT_EQ(::poll(&waited, 1, 5000), 1);  // the end of the pipe: nobody else can write to it
  EXPECT_NE(waited.revents & POLLHUP, 0);
  ::close(pipe[0]);
}

TEST(Keeper, WhereNoFileIsIsAnError) { EXPECT_THROW(Keeper("/no/such/file", "x"), Error); }

TEST(CreateBase, TheWheelsStopWhenTheProcessIsKilled) {
  auto line = std::make_unique<PseudoTerminal>();
  ChildProcess driver([path = line->path()] {
    CreateBase base(createAt(path));
    for (;; std::this_thread::sleep_for(std::chrono::milliseconds(20))) base.drive({0.2, 0.0, 0.0});
  });
  CreateEmulator robot(std::move(line));
  ASSERT_TRUE(eventually([&] { return robot.wheels().left_mps > 0.0; }));
  const auto killed = std::chrono::steady_clock::now();
  driver.end(SIGKILL);
  ASSERT_TRUE(eventually([&] { return robot.wheels().left_mps == 0.0; }));
  const std::chrono::duration<double> after = robot.lastDrive().at - killed;
  RecordProperty("stopped_after_ms", static_cast<int>(1e3 * after.count()));
  EXPECT_LT(after.count(), 1.0);  // below 1 ms when the machine has nothing else to do
}

}  // namespace
}  // namespace bslnav::test
