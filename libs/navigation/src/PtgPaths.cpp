#include "PtgPaths.h"

#include <bslnav/config/Error.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace bslnav {

using mrpt::math::TPose2D;

mrpt::math::TTwist2D commandOf(const mrpt::kinematics::CVehicleVelCmd& command) {
  if (const auto* drive =
          dynamic_cast<const mrpt::kinematics::CVehicleVelCmd_DiffDriven*>(&command))
    return {drive->lin_vel, 0.0, drive->ang_vel};
  if (const auto* holonomic = dynamic_cast<const mrpt::kinematics::CVehicleVelCmd_Holo*>(&command))
    return {holonomic->vel * std::cos(holonomic->dir_local),
            holonomic->vel * std::sin(holonomic->dir_local), holonomic->rot_speed};
  throw Error("PTG", "its commands are neither of a differential nor of a holonomic robot",
              Error::Kind::Run);
}

void setVelocity(const mrpt::math::TTwist2D& twist, mrpt::kinematics::CVehicleVelCmd& command) {
  if (auto* drive = dynamic_cast<mrpt::kinematics::CVehicleVelCmd_DiffDriven*>(&command)) {
    drive->lin_vel = twist.vx;
    drive->ang_vel = twist.omega;
  } else if (auto* holonomic = dynamic_cast<mrpt::kinematics::CVehicleVelCmd_Holo*>(&command)) {
    holonomic->vel = std::hypot(twist.vx, twist.vy);
    holonomic->dir_local = std::atan2(twist.vy, twist.vx);
    holonomic->rot_speed = twist.omega;
  }
}

void samplePath(const mrpt::nav::CParameterizedTrajectoryGenerator& ptg, std::uint16_t k,
                double reach_m, double spacing_m, SampledPath& path) {
  path.clear();
  path.add({}, 0.0);
  TPose2D last;
  double driven_m = 0.0;
  const auto steps = static_cast<std::uint32_t>(ptg.getPathStepCount(k));
  for (std::uint32_t step = 1; step < steps && driven_m < reach_m; ++step) {
    const TPose2D pose = ptg.getPathPose(k, step);
    const double chord_m = std::hypot(pose.x - last.x, pose.y - last.y);
    const bool isLast = step + 1 == steps || driven_m + chord_m >= reach_m;
    if (chord_m < 0.5 * spacing_m && !isLast) continue;
    const int pieces = std::max(1, static_cast<int>(std::ceil(chord_m / spacing_m)));
    for (int i = 1; i <= pieces; ++i) {
      const double part = static_cast<double>(i) / pieces;
      path.add({last.x + part * (pose.x - last.x), last.y + part * (pose.y - last.y),
                last.phi + part * mrpt::math::wrapToPi(pose.phi - last.phi)},
               driven_m + part * chord_m);
    }
    driven_m += chord_m;
    last = pose;
  }
  if (path.size() == 1) path.add({}, 0.0);  // leads nowhere
}

}  // namespace bslnav
