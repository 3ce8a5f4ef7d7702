#include "MvsimRobot.h"

#include <bslnav/config/Config.h>

#include <cmath>

namespace bslnav {
namespace {

constexpr double kDegPerRad = 180.0 / M_PI;

void writeLaser(MvsimXml& xml, const std::string& name, const LaserParameters& laser) {
  xml.open("sensor", {{"class", "laser"}, {"name", name}});
  xml.leaf("pose_3d",
           xmlNumbers({laser.x_m, laser.y_m, laser.z_m, laser.yaw_rad * kDegPerRad, 0.0, 0.0}));
  xml.leaf("fov_degrees", xmlNumbers({laser.fov_rad * kDegPerRad}));
  xml.leaf("nrays", std::to_string(laser.beams));
  xml.leaf("max_range", xmlNumbers({laser.maxRange_m}));
  xml.leaf("range_std_noise", xmlNumbers({laser.noiseStd_m}));
  xml.leaf("angle_std_noise_deg", "0");
  xml.leaf("sensor_period", xmlNumbers({1.0 / laser.rate_hz}));
  xml.leaf("raytrace_3d", "false");  // exact rays in the plane, without a graphics card
  xml.close();
}

void writeCamera(MvsimXml& xml, const std::string& name, const DepthCameraParameters& camera) {
  const auto size = [&xml](const std::string& key, int pixels) {
    xml.leaf(key, std::to_string(pixels));
  };
  xml.open("sensor", {{"class", "rgbd_camera"}, {"name", name}});
  xml.leaf("pose_3d", xmlNumbers({camera.x_m, camera.y_m, camera.z_m, camera.yaw_rad * kDegPerRad,
                                  camera.pitch_rad * kDegPerRad, camera.roll_rad * kDegPerRad}));
  xml.leaf("sensor_period", xmlNumbers({1.0 / camera.rate_hz}));
  xml.leaf("sense_depth", "true");
  xml.leaf("sense_rgb", "false");
  size("depth_ncols", camera.columns);
  size("depth_nrows", camera.rows);
  xml.leaf("depth_cx", xmlNumbers({0.5 * (camera.columns - 1)}));
  xml.leaf("depth_cy", xmlNumbers({0.5 * (camera.rows - 1)}));
  xml.leaf("depth_fx", xmlNumbers({0.5 * camera.columns / std::tan(0.5 * camera.hfov_rad)}));
  xml.leaf("depth_fy", xmlNumbers({0.5 * camera.rows / std::tan(0.5 * camera.vfov_rad)}));
  xml.leaf("depth_clip_min", xmlNumbers({camera.minRange_m}));
  xml.leaf("depth_clip_max", xmlNumbers({camera.maxRange_m}));
  xml.leaf("depth_resolution", "0.001");
  xml.close();
}

/** A differential drive whose wheels stand half-way between centre and side. */
void writeDrive(MvsimXml& xml, const RobotOutline& outline) {
  const auto chassis = outline.polygon.empty() ? mvsimCircle(outline.radius_m) : outline.polygon;
  double side_m = 0.0;
  for (const auto& corner : chassis) side_m = std::max(side_m, std::abs(corner.y));
  xml.open("dynamics", {{"class", "differential"}});
  for (const int side : {1, -1})
    xml.leaf(side > 0 ? "l_wheel" : "r_wheel", "",
             {{"pos", xmlNumbers({0.0, side * 0.5 * side_m})},
              {"mass", "2"},
              {"width", "0.04"},
              {"diameter", "0.1"}});
  xml.open("chassis", {{"mass", "15"}, {"zmin", "0.05"}, {"zmax", xmlNumbers({outline.height_m})}});
  writeShape(xml, chassis);
  xml.close();
  xml.leaf("controller", "", {{"class", "twist_ideal"}});
  xml.close();
}

}  // namespace

void writeShape(MvsimXml& xml, const std::vector<mrpt::math::TPoint2D>& polygon) {
  xml.open("shape");
  for (const auto& corner : polygon) xml.leaf("pt", xmlNumbers({corner.x, corner.y}));
  xml.close();
}

std::vector<mrpt::math::TPoint2D> mvsimCircle(double radius_m) {
  constexpr double kHalfAngle = M_PI / kMvsimCorners;
  const double corner_m = 2.0 * radius_m / (1.0 + std::cos(kHalfAngle));
  std::vector<mrpt::math::TPoint2D> polygon;
  for (int i = 0; i < kMvsimCorners; ++i)
    polygon.emplace_back(corner_m * std::cos(2 * i * kHalfAngle),
                         corner_m * std::sin(2 * i * kHalfAngle));
  return polygon;
}

void writeRobot(MvsimXml& xml, const SimulationCase& simulated) {
  if (simulated.robot.kinematics == BaseKinematics::Holonomic)
    Config::refuse("simulated_robot", "kinematics", "diff_drive: MVSim has no holonomic base");
  if (simulated.outline.polygon.size() > kMvsimCorners)
    Config::refuse("footprint", "polygon_m",
                   "at most " + std::to_string(kMvsimCorners) + " corners for MVSim");
  const auto& start = simulated.start;
  xml.open("vehicle", {{"name", "robot"}});
  xml.leaf("init_pose", xmlNumbers({start.x, start.y, start.phi * kDegPerRad}));
  writeDrive(xml, simulated.outline);
  // MVSim's damping of 1 would make the speeds of wheels as light as these diverge.
  xml.open("friction", {{"class", "default"}});
  xml.leaf("mu", "0.7");
  xml.leaf("C_damping", "0.01");
  xml.close();
  for (const auto& [name, laser] : simulated.lasers) writeLaser(xml, name, laser);
  for (const auto& [name, camera] : simulated.cameras) writeCamera(xml, name, camera);
  xml.close();
}

}  // namespace bslnav
