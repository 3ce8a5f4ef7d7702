#include "PtgPaths.h"

#include <bslnav/config/Error.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

using mrpt::math::TPose2D;

mrpt::math::TTwist2D commandOf(const mrpt::kinematics::CVehicleVelCmd& command) {
  if (const auto* drive =
          dynamic_cast<const mrpt::kinematics::CVehicleVelCmd_DiffDriven*>(&command))
    return {drive->lin_vel, 0.0, drive->ang_vel};
  if (const auto* holonomic =
          dynamic_cast<const mrpt::kinematics::CVehicleVelCmd_Holo*>(&command)) {
    // MRPT means: turn until facing where it drives. Ours is a rate, so it must fade on the way.
    constexpr double kFacing_s = 0.5;
    const double direction = holonomic->dir_local;
    const double rate = std::min(std::abs(holonomic->rot_speed), std::abs(direction) / kFacing_s);
    return {holonomic->vel * std::cos(direction), holonomic->vel * std::sin(direction),
            std::copysign(rate, holonomic->rot_speed)};
  }
  throw Error("PTG", "its commands are neither of a differential nor of a holonomic robot",
              Error::Kind::Run);
}

void setVelocity(const mrpt::math::TTwist2D& twist, mrpt::kinematics::CVehicleVelCmd& command) {
  if (auto* drive = dynamic_cast<mrpt::kinematics::CVehicleVelCmd_DiffDriven*>(&command)) {
    drive->lin_vel = twist.vx;
    drive->ang_vel = twist.omega;
  } else if (auto* holonomic = dynamic_cast<mrpt::kinematics::CVehicleVelCmd_Holo*>(&command)) {
    holonomic->vel = std::hypot(twist.vx, twist.vy);
    // MRPT turns towards the direction: of a robot that stands, that is to the side it turns to
    holonomic->dir_local = holonomic->vel > 0.0 ? std::atan2(twist.vy, twist.vx)
                                                : std::copysign(0.5 * M_PI, twist.omega);
    holonomic->rot_speed = twist.omega;
    holonomic->ramp_time = 0.1;  // the limits are kept already
  } else {
    throw Error("robot interface",
                "its commands are neither of a differential nor of a "
                "holonomic robot",
                Error::Kind::Run);
  }
}

void samplePath(const mrpt::nav::CParameterizedTrajectoryGenerator& ptg, std::uint16_t k,
                double reach_m, double spacing_m, SampledPath& path) {
  path.clear();
  path.add({}, 0.0);
  TPose2D last;
  double driven_m = 0.0;
  const auto count = static_cast<std::uint32_t>(ptg.getPathStepCount(k));
  const std::uint32_t end = std::max(count, 1U) - 1;
  std::uint32_t stride = 1;  // of the PTG's own steps, which may be far shorter than the spacing
  for (std::uint32_t step = 0; step < end && driven_m < reach_m;) {
    step = std::min(step + stride, end);
    const TPose2D pose = ptg.getPathPose(k, step);
    const double chord_m = std::hypot(pose.x - last.x, pose.y - last.y);
    const double fitting = stride * spacing_m / std::max(chord_m, 0.25 * spacing_m);
    stride = std::max(1U, static_cast<std::uint32_t>(fitting));
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
