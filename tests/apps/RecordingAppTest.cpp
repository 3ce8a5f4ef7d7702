#include <cstdlib>
#include <sstream>

#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/** The commands of cycles.csv, row by row. */
std::string commandsOf(const std::string& file) {
  std::istringstream rows(readFile(file));
  std::string row, header, commands;
  std::getline(rows, header);
  std::vector<std::string> names, cells;
  const auto split = [](const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
    return words;
  };
  names = split(header);
  while (std::getline(rows, row)) {
    cells = split(row);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i].rfind("command", 0) == 0) commands += names[i] + "=" + cells.at(i) + " ";
    commands += '\n';
  }
  return commands;
}

class Recording : public AppTest {};

/* Either with the files that the run was made with, or with the configuration that it left. */
TEST_F(Recording, OfMethod2GivesTheSameCommandsAgain) {
  const AppResult first = drive(kS1, {"--method", "2", "--set", "recording.rawlog=true"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const AppResult second =
      run({kS1, "--method", "2", "--rawlog", out("run.rawlog"), "--out", path("again")},
          "bslnav-rawlog");
  ASSERT_EQ(second.exitCode, 0) << second.err;
  ASSERT_THAT(commandsOf(out("cycles.csv")), HasSubstr("="));
  EXPECT_TRUE(commandsOf(out("cycles.csv", "again")) == commandsOf(out("cycles.csv")));
}

TEST_F(Recording, OfMethod4GivesTheSameCommandsAgain) {
  const AppResult first = drive(kS1, {"--method", "4", "--set", "recording.rawlog=true"});
  ASSERT_EQ(first.exitCode, 0) << first.err;
  const AppResult second = run(
      {out("config.ini"), "--rawlog", out("run.rawlog"), "--out", path("again")}, "bslnav-rawlog");
  ASSERT_EQ(second.exitCode, 0) << second.err;
  ASSERT_THAT(commandsOf(out("cycles.csv")), HasSubstr("="));
  EXPECT_TRUE(commandsOf(out("cycles.csv", "again")) == commandsOf(out("cycles.csv")));
}

TEST_F(Recording, IsOffUnlessAskedFor) {
  ASSERT_EQ(drive(write("room.ini", kRoom)).exitCode, 0);
  for (const char* file : {"run.rawlog", "run.3Dscene", "scene.png"})
    EXPECT_FALSE(exists(out(file))) << file;
}

TEST_F(Recording, DoesNotChangeTheRun) {
  const std::string room = write("room.ini", kRoom);
  ASSERT_EQ(drive(room, {}, "plain").exitCode, 0);
  ASSERT_EQ(
      drive(room, {"--set", "recording.rawlog=true", "--set", "recording.scene=true"}).exitCode, 0);
  EXPECT_TRUE(readFile(out("cycles.csv")) == readFile(out("cycles.csv", "plain")));
  EXPECT_TRUE(exists(out("run.rawlog")));
  EXPECT_TRUE(exists(out("run.3Dscene")));
}

TEST_F(Recording, DrawsTheSceneOrSaysWhyNot) {
  const AppResult result =
      drive(write("room.ini", kRoom), {"--set", "recording.scene_picture=true"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  if (exists(out("scene.png"))) {
    EXPECT_THAT(readFile(out("scene.png")), StartsWith("\x89PNG"));
    EXPECT_THAT(result.out, HasSubstr("scene.png"));
  } else {
    EXPECT_THAT(result.err, HasSubstr("no scene.png: no OpenGL context"));
  }
}

/* With an empty directory of drivers EGL has no device. */
TEST_F(Recording, NoOpenGlIsAWarning) {
  ASSERT_EQ(setenv("__EGL_VENDOR_LIBRARY_DIRS", path("no_drivers").c_str(), 1), 0);
  const AppResult result =
      drive(write("room.ini", kRoom), {"--set", "recording.scene_picture=true"});
  unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no scene.png: no OpenGL context"));
  EXPECT_FALSE(exists(out("scene.png")));
  EXPECT_TRUE(exists(out("trajectory.png")));
}

}  // namespace
}  // namespace bslnav::test
