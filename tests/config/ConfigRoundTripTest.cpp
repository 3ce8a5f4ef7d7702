#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ConfigFixture.h"

namespace bslnav::test {
namespace {

double any(double low, double high) {
  return low +
         (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1000001)) / 1e6;
}

Everything anything() {
  Everything values;
  values.speed_mps = any(-10.0, 10.0);
  values.angle_rad = any(-M_PI, M_PI);
  values.count = *rc::gen::inRange(-100, 101);
  values.enabled = *rc::gen::arbitrary<bool>();
  values.name = *rc::gen::element<std::string>("", "a b", "x=y", "1.0", "[a", "#1");
  values.colour = *rc::gen::element(Colour::Red, Colour::Green);
  values.outline.clear();
  for (int n = *rc::gen::inRange(2, 6); n > 0; --n)
    values.outline.emplace_back(any(-5.0, 5.0), any(-1e-9, 1e9));
  values.speeds.assign(static_cast<std::size_t>(*rc::gen::inRange(0, 4)), any(0.0, 3.0));
  values.start = {any(-5.0, 5.0), any(-5.0, 5.0), any(-M_PI, M_PI)};
  values.goals.assign(static_cast<std::size_t>(*rc::gen::inRange(0, 4)), values.start);
  return values;
}

std::string printed(const Config& config) {
  std::ostringstream out;
  config.print(out);
  return out.str();
}

/** The lines that set something: defaults in the comments are those of the program that prints. */
std::string assignments(const std::string& text) {
  std::istringstream in(text);
  std::string result;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != ';') result += line + "\n";
  return result;
}

RC_GTEST_PROP(ConfigLaw, APrintedConfigurationLoadsBackToTheSameText, ()) {
  Everything first = anything(), second;
  std::map<std::string, Wall> firstWalls, secondWalls;
  Config from, to;
  from.bind("robot", "The robot.", first);
  from.bindRepeated("wall", "A wall.", firstWalls);
  from.load({}, {"wall:left.height_m=" + std::to_string(any(0.1, 3.0))});
  to.bind("robot", "The robot.", second);
  to.bindRepeated("wall", "A wall.", secondWalls);
  const std::string path = testing::TempDir() + "/bslnav_round_trip.ini";
  std::ofstream(path) << printed(from);
  to.load({path});
  RC_ASSERT(assignments(printed(to)) == assignments(printed(from)));
  RC_ASSERT(second.speed_mps == first.speed_mps);
  RC_ASSERT(std::abs(second.angle_rad - first.angle_rad) < 1e-10);
  RC_ASSERT(second.outline == first.outline);
}

}  // namespace
}  // namespace bslnav::test
