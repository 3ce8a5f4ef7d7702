#include <bslnav/simulation/SimulatedBase.h>
#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>
#include <mrpt/kinematics/CVehicleSimul_Holo.h>

#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

constexpr int kPeriods = 20;  // of MRPT's inner loop in one call of move()

class DiffDriveBase final : public SimulatedBase,
                            private mrpt::kinematics::CVehicleSimul_DiffDriven {
 public:
  DiffDriveBase(const TPose2D& start, double lag_s) {
    setCurrentGTPose(start);
    setDelayModelParams(lag_s, 0.0);
  }

  void move(const TTwist2D& from, const TTwist2D& to, double gain, double dt_s) override {
    // The command whose lag ends at `to` after this step.
    movementCommand(from.vx + (to.vx - from.vx) / gain,
                    from.omega + (to.omega - from.omega) / gain);
    // MRPT's loop runs while time <= end, a period too many when asked for whole ones.
    m_firmware_control_period = dt_s / kPeriods;
    simulateOneTimeStep(dt_s - 0.5 * m_firmware_control_period);
    setV(to.vx);  // the model sees the lag a period late and would never stand quite still
    setW(to.omega);
  }
  const TPose2D& pose() const override { return getCurrentGTPose(); }
};

/** MRPT's model blends velocities linearly in a frame that does not turn with the robot, and turns
 * the robot towards where it drives; here the direction leads to the velocity as it points after
 * the step, and the turn is set from outside. */
class HolonomicBase final : public SimulatedBase, private mrpt::kinematics::CVehicleSimul_Holo {
 public:
  explicit HolonomicBase(const TPose2D& start) {
    setCurrentGTPose(start);
    setCurrentOdometricPose(start);  // MRPT's frame of velocities: here the map
  }

  void move(const TTwist2D& from, const TTwist2D& to, double /*gain*/, double dt_s) override {
    const double yawRate = 0.5 * (from.omega + to.omega);
    TTwist2D target{to.vx, to.vy, yawRate};
    target.rotate(getCurrentGTPose().phi + yawRate * dt_s);
    sendVelRampCmd(std::hypot(target.vx, target.vy), std::atan2(target.vy, target.vx), dt_s, 0.0);
    m_firmware_control_period = dt_s / kPeriods;
    for (int i = 0; i < kPeriods; ++i) {
      m_odometric_vel.omega = m_GT_vel.omega = yawRate;
      simulateOneTimeStep(0.5 * m_firmware_control_period);  // one period
    }
    m_odometric_vel = m_GT_vel = target;  // the model sees the end of its ramp a period late
  }
  const TPose2D& pose() const override { return getCurrentGTPose(); }
};

}  // namespace

std::unique_ptr<SimulatedBase> makeSimulatedBase(BaseKinematics kinematics, const TPose2D& start,
                                                 double lag_s) {
  if (kinematics == BaseKinematics::Holonomic) return std::make_unique<HolonomicBase>(start);
  return std::make_unique<DiffDriveBase>(start, lag_s);
}

}  // namespace bslnav
