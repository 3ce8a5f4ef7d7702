#include <bslnav/config/Error.h>
#include <bslnav/navigation/PtgNavigation.h>
#include <bslnav/planning/DynamicWindow.h>
#include <mrpt/nav/reactive/TCandidateMovementPTG.h>
#include <mrpt/rtti/CObject.h>

#include "PtgPaths.h"

namespace bslnav {

PtgNavigation::PtgNavigation(mrpt::nav::CRobot2NavInterface& robot, bool consoleOutput,
                             bool logFile, const std::string& logDirectory)
    : EndsWhenFailed(robot, consoleOutput, logFile, logDirectory) {
  mrpt::rtti::registerClass(CLASS_ID(CHolonomicDwa));
}

void PtgNavigation::use(const DwaParameters& dwa, const RobotLimits& limits, double controlPeriod_s,
                        std::shared_ptr<CandidateEvaluator> evaluator) {
  dwa_ = dwa;
  limits_ = limits;
  controlPeriod_s_ = controlPeriod_s;
  evaluator_ = std::move(evaluator);
}

void PtgNavigation::loadConfigFile(const mrpt::config::CConfigFileBase& file) {
  CReactiveNavigationSystem::loadConfigFile(file);
  for (std::size_t i = 0; i < m_holonomicMethod.size(); ++i)
    if (method(i) && evaluator_) method(i)->use(dwa_, limits_, controlPeriod_s_, evaluator_);
}

CHolonomicDwa* PtgNavigation::method(std::size_t ptg) const {
  return dynamic_cast<CHolonomicDwa*>(m_holonomicMethod[ptg].get());
}

void PtgNavigation::silence() {
  logging_enable_console_output = false;
  for (auto* log : {&m_timlog_delays, &m_timelogger, &m_navProfiler})
    log->setMinLoggingLevel(mrpt::system::LVL_ERROR);
}

void PtgNavigation::setSituation(const DwaSituation* situation) {
  situation_ = situation;
  for (std::size_t i = 0; i < m_holonomicMethod.size(); ++i)
    if (method(i)) method(i)->setSituation(situation);
}

void PtgNavigation::onStartNewNavigation() {
  if (evaluator_) evaluator_->reset();
  EndsWhenFailed::onStartNewNavigation();
}

void PtgNavigation::performNavigationStep() {
  chosen_ = nullptr;
  result_.command = {};
  attempt([this] { CReactiveNavigationSystem::performNavigationStep(); });
  collectResult();
}

double PtgNavigation::generate_vel_cmd(const mrpt::nav::TCandidateMovementPTG& movement,
                                       mrpt::kinematics::CVehicleVelCmd::Ptr& command) {
  const double scale = CReactiveNavigationSystem::generate_vel_cmd(movement, command);
  chosen_ = movement.PTG;
  if (!command) return scale;
  const auto& from = situation_ ? situation_->input.twist : m_curPoseVel.velLocal;
  auto wanted = commandOf(*command);
  if (situation_)
    wanted = withinWindow(wanted, from, limits_, controlPeriod_s_,
                          speedCap(situation_->input, limits_, controlPeriod_s_));
  result_.command = limited(wanted, from, limits_, controlPeriod_s_);
  setVelocity(result_.command, *command);
  return scale;
}

void PtgNavigation::collectResult() {
  result_.candidates.clear();
  result_.best = -1;
  for (std::size_t i = 0; i < m_holonomicMethod.size(); ++i) {
    if (!method(i)) continue;
    const DwaResult& ofPtg = method(i)->result();
    if (chosen_ && chosen_ == getPTG(i) && ofPtg.best >= 0)
      result_.best = static_cast<int>(result_.candidates.size()) + ofPtg.best;
    result_.setup = ofPtg.setup;
    result_.candidates.insert(result_.candidates.end(), ofPtg.candidates.begin(),
                              ofPtg.candidates.end());
  }
  result_.status = result_.best < 0 ? DwaResult::Status::NoAdmissible : DwaResult::Status::Ok;
}

}  // namespace bslnav
