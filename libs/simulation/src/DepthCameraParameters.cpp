#include <bslnav/config/Config.h>
#include <bslnav/simulation/DepthCameraParameters.h>

namespace bslnav {
namespace {

constexpr double kFarthest_m = 60.0;  // depths are 16-bit millimetres
constexpr double kWidest_deg = 170.0;
constexpr int kMostPixels = 4096;  // in a row or a column

}  // namespace

void DepthCameraParameters::describe(ConfigSection& section) {
  section.number("x_m", x_m, {}, "m", "position on the robot, forward");
  section.number("y_m", y_m, {}, "m", "position on the robot, to the left");
  section.number("z_m", z_m, kPositive, "m", "height above the floor");
  section.angle("yaw_deg", yaw_rad, {-360.0, 360.0}, "direction of view on the robot, to the left");
  section.angle("pitch_deg", pitch_rad, {-90.0, 90.0}, "direction of view, positive looks down");
  section.angle("roll_deg", roll_rad, {-180.0, 180.0}, "turn about the direction of view");
  section.angle("hfov_deg", hfov_rad, {1.0, kWidest_deg}, "horizontal field of view");
  section.angle("vfov_deg", vfov_rad, {1.0, kWidest_deg}, "vertical field of view");
  section.integer("columns", columns, {2, kMostPixels}, "", "pixels of a row");
  section.integer("rows", rows, {2, kMostPixels}, "", "pixels of a column");
  section.number("min_range_m", minRange_m, {0.0, kFarthest_m}, "m", "smaller depths are not seen");
  section.number("max_range_m", maxRange_m, {0.0, kFarthest_m}, "m", "larger depths are not seen");
  section.number("rate_hz", rate_hz, {0.1, 100.0}, "Hz", "frames a second");
  section.number("latency_s", latency_s, {0.0, 10.0}, "s", "from the measurement to its delivery");
  section.number("noise_coefficient", noiseCoefficient, {0.0, 1.0}, "1/m",
                 "standard deviation of a depth z: this times z²");
  section.number("dropout_probability", dropoutProbability, {0.0, 1.0}, "",
                 "share of pixels that see nothing");
  section.number("edge_step_m", edgeStep_m, kPositive, "m",
                 "neighbours in a row or column whose depths differ by more are at an edge");
  section.number("edge_dropout_probability", edgeDropoutProbability, {0.0, 1.0}, "",
                 "share of pixels at an edge that see nothing, besides dropout_probability");
}

void DepthCameraParameters::check(const std::string& name) const {
  const auto require = [&name](bool good, const char* key, const char* expected) {
    if (!good) Config::refuse("camera:" + name, key, expected);
  };
  const auto isView = [](double fov_rad) {
    return fov_rad > 0.0 && fov_rad <= kWidest_deg / 180.0 * M_PI;
  };
  const auto isSize = [](int pixels) { return pixels >= 2 && pixels <= kMostPixels; };
  require(isView(hfov_rad), "hfov_deg", "an angle above 0 and up to 170");
  require(isView(vfov_rad), "vfov_deg", "an angle above 0 and up to 170");
  require(isSize(columns), "columns", "an integer from 2 to 4096");
  require(isSize(rows), "rows", "an integer from 2 to 4096");
  require(z_m > 0.0, "z_m", "a number above 0");
  require(minRange_m >= 0.0, "min_range_m", "a number from 0");
  require(maxRange_m > minRange_m, "max_range_m", "a range above min_range_m");
  require(maxRange_m <= kFarthest_m, "max_range_m", "a range of at most 60 m");
  require(rate_hz > 0.0, "rate_hz", "a number above 0");
}

}  // namespace bslnav
