#pragma once

#include <bslnav/navigation/CHolonomicDwa.h>
#include <bslnav/navigation/EndsWhenFailed.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>

#include <memory>
#include <string>

namespace bslnav {

/** MRPT's PTG-based reactive navigation with CHolonomicDwa over a cost map: commands keep the
 * acceleration limits, and a step that fails ends the navigation.
 *
 * Whoever owns it gives the situation before each navigationStep(). Methods other than
 * CHolonomicDwa work as in MRPT, then without the situation. */
class PtgNavigation : public EndsWhenFailed<mrpt::nav::CReactiveNavigationSystem> {
 public:
  /** As CReactiveNavigationSystem's. */
  PtgNavigation(mrpt::nav::CRobot2NavInterface& robot, bool consoleOutput = true,
                bool logFile = false, const std::string& logDirectory = "./reactivenav.logs");
  ~PtgNavigation() override { preDestructor(); }

  /** What CHolonomicDwa judges by; to be called before loadConfigFile().
   *  @param evaluator shared by the methods of all PTGs */
  void use(const DwaParameters& dwa, const RobotLimits& limits, double controlPeriod_s,
           std::shared_ptr<CandidateEvaluator> evaluator);
  void loadConfigFile(const mrpt::config::CConfigFileBase& file) override;

  /** Says nothing any more but by problem(): MRPT warns of every uneven period. */
  void silence();

  /** What the next steps are decided by; must live as long as they run. */
  void setSituation(const DwaSituation* situation);
  /** The candidates of all PTGs in the last step; `best` is the one that was sent. */
  const DwaResult& result() const { return result_; }
  /** What was sent in the last step, robot frame; zero for a stop. */
  const mrpt::math::TTwist2D& lastVelocity() const { return result_.command; }

 protected:
  void performNavigationStep() override;
  double generate_vel_cmd(const mrpt::nav::TCandidateMovementPTG& movement,
                          mrpt::kinematics::CVehicleVelCmd::Ptr& command) override;
  void onStartNewNavigation() override;

 private:
  CHolonomicDwa* method(std::size_t ptg) const;  // null when it is another kind
  void collectResult();

  DwaParameters dwa_;
  RobotLimits limits_;
  double controlPeriod_s_ = 0.1;
  std::shared_ptr<CandidateEvaluator> evaluator_;
  const DwaSituation* situation_ = nullptr;
  const mrpt::nav::CParameterizedTrajectoryGenerator* chosen_ = nullptr;
  DwaResult result_;
};

}  // namespace bslnav
