#pragma once

#include <exception>
#include <mutex>
#include <string>
#include <utility>

namespace bslnav {

/** One of MRPT's navigators (a CWaypointsNavigator) whose navigation ends when a step fails. MRPT
 * logs the failure and tries again for ever. */
template <typename Base>
class EndsWhenFailed : public Base {
 public:
  using Base::Base;

  void navigationStep() override {
    const std::lock_guard<std::recursive_mutex> waypoints(
        this->m_nav_waypoints_cs);  // MRPT's order
    const std::lock_guard<std::recursive_mutex> lock(this->m_nav_cs);
    failed_ = false;
    try {
      Base::navigationStep();
    } catch (const std::exception&) {
      if (!failed_) throw;
    }
    if (failed_) this->m_navigationState = Base::NAV_ERROR;
  }

  /** Why the last navigation ended; empty when it has not failed. */
  const std::string& problem() const { return problem_; }

 protected:
  /** Whether this step has failed. */
  bool failing() const { return failed_; }

  /** Does a part of a step; if it throws, the robot is stopped and the step has failed. */
  template <typename Work>
  void attempt(Work&& work) {
    try {
      std::forward<Work>(work)();
    } catch (const std::exception& problem) {
      doEmergencyStop(problem.what());
    }
  }

  void updateCurrentPoseAndSpeeds() override {
    try {
      Base::updateCurrentPoseAndSpeeds();
    } catch (const std::exception& problem) {
      failed_ = true;
      problem_ = problem.what();
      throw;
    }
  }
  void doEmergencyStop(const std::string& message) override {
    problem_ = message;
    failed_ = true;
    Base::doEmergencyStop(message);
  }
  void onStartNewNavigation() override {
    problem_.clear();
    Base::onStartNewNavigation();
  }

 private:
  bool failed_ = false;  // in this step
  std::string problem_;
};

}  // namespace bslnav
