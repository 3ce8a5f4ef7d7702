#include <bslnav/config/Error.h>
#include <bslnav/navigation/PtgNavigation.h>
#include <bslnav/planning/DynamicWindow.h>
#include <mrpt/nav/reactive/TCandidateMovementPTG.h>
#include <mrpt/rtti/CObject.h>

#include "PtgPaths.h"

namespace bslnav {
PtgNavigation::PtgNavigation(mrpt::nav::CRobot2NavInterface& robot, bool consoleOutput,
                             bool logFile, const std::string& logDirectory)
    : CReactiveNavigationSystem(robot, consoleOutput, logFile, logDirectory) {
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
  methods_.clear();
  for (const auto& method : m_holonomicMethod) {
    auto* ours = dynamic_cast<CHolonomicDwa*>(method.get());
    if (ours && evaluator_) ours->use(dwa_, limits_, controlPeriod_s_, evaluator_);
    methods_.push_back(ours);
  }
}

void PtgNavigation::silence() {
  logging_enable_console_output = false;
  for (auto* log : {&m_timlog_delays, &m_timelogger, &m_navProfiler})
    log->setMinLoggingLevel(mrpt::system::LVL_ERROR);
}

void PtgNavigation::setSituation(const DwaSituation* situation) {
  situation_ = situation;
  for (CHolonomicDwa* method : methods_)
    if (method) method->setSituation(situation);
}

void PtgNavigation::onStartNewNavigation() {
  problem_.clear();
  if (evaluator_) evaluator_->reset();
  CReactiveNavigationSystem::onStartNewNavigation();
}

/** MRPT logs a step that failed and tries again for ever. */
void PtgNavigation::navigationStep() {
  const std::lock_guard<std::recursive_mutex> lock(m_nav_cs);
  failed_ = false;
  CReactiveNavigationSystem::navigationStep();
  if (failed_) m_navigationState = NAV_ERROR;
}

void PtgNavigation::performNavigationStep() {
  chosen_ = nullptr;
  result_.command = {};
  try {
    CReactiveNavigationSystem::performNavigationStep();
  } catch (const std::exception& problem) {
    doEmergencyStop(problem.what());
  }
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

void PtgNavigation::doEmergencyStop(const std::string& message) {
  problem_ = message;
  failed_ = true;
  CReactiveNavigationSystem::doEmergencyStop(message);
}

void PtgNavigation::collectResult() {
  result_.candidates.clear();
  result_.best = -1;
  for (std::size_t i = 0; i < methods_.size(); ++i) {
    if (!methods_[i]) continue;
    const DwaResult& ofPtg = methods_[i]->result();
    if (chosen_ && chosen_ == getPTG(i) && ofPtg.best >= 0)
      result_.best = static_cast<int>(result_.candidates.size()) + ofPtg.best;
    result_.setup = ofPtg.setup;
    result_.candidates.insert(result_.candidates.end(), ofPtg.candidates.begin(),
                              ofPtg.candidates.end());
  }
  result_.status = result_.best < 0 ? DwaResult::Status::NoAdmissible : DwaResult::Status::Ok;
}

}  // namespace bslnav
