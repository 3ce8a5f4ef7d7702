#pragma once

#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace bslnav::test {

enum class Colour { Red, Green };

struct Wall {
  double height_m = 2.0;

  void describe(ConfigSection& section) {
    section.number("height_m", height_m, kPositive, "m", "height of the wall");
  }
};

/** One key of every kind. */
struct Everything {
  double speed_mps = 0.5, angle_rad = 0.25;
  int count = 3;
  bool enabled = false;
  std::string name = "robot";
  Colour colour = Colour::Green;
  std::vector<mrpt::math::TPoint2D> outline{{0.0, 1.0}, {2.0, 3.0}};
  std::vector<double> speeds{1.0, 2.5};
  mrpt::math::TPose2D start{1.0, 2.0, 0.5};
  std::vector<mrpt::math::TPose2D> goals;

  void describe(ConfigSection& section) {
    section.number("speed_mps", speed_mps, {-10.0, 10.0}, "m/s", "a speed");
    section.angle("angle_deg", angle_rad, {-180.0, 180.0}, "an angle");
    section.integer("count", count, {-100, 100}, "", "a count");
    section.flag("enabled", enabled, "a switch");
    section.text("name", name, "a name");
    section.choice("colour", colour, {{"red", Colour::Red}, {"green", Colour::Green}}, "a colour");
    section.points("outline_m", outline, 2, "an outline");
    section.numbers("speeds_mps", speeds, kNonNegative, "m/s", "some speeds");
    section.pose("start", start, "a pose");
    section.poses("goals", goals, "some poses");
  }
};

/** A configuration with the sections [robot] and [wall:NAME], and a file to load into it. */
class ConfigTest : public testing::Test {
 protected:
  ConfigTest() {
    config.bind("robot", "The robot.", robot);
    config.bindRepeated("wall", "A wall.", walls);
  }

  /** Path of a new file with this text. */
  static std::string file(const std::string& text, const std::string& name = "config.ini") {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string path = std::string("bslnav_") + test->name() + "_" + name;
    std::replace(path.begin(), path.end(), '/', '_');  // of parameterised tests
    path = testing::TempDir() + "/" + path;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  void load(const std::string& text) { config.load({file(text)}); }

  /** What loading the text is refused with; "" if it is not. */
  std::string refusal(const std::string& text) {
    try {
      load(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  std::string printed() const {
    std::ostringstream out;
    config.print(out);
    return out.str();
  }

  Everything robot;
  std::map<std::string, Wall> walls;
  Config config;
};

}  // namespace bslnav::test
