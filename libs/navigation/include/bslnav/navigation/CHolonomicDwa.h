#pragma once

#include <bslnav/planning/CandidateEvaluator.h>
#include <mrpt/nav/holonomic/CAbstractHolonomicReactiveMethod.h>

#include <memory>

namespace bslnav {

/** What a cycle gives to CHolonomicDwa beside MRPT's TP-obstacles. */
struct DwaSituation {
  DwaInput input;         ///< map frame
  const CostGrid* costs;  ///< must live as long as the navigation step
};

/** The paper's cost function as a holonomic method of MRPT's PTG-based navigation: scores every
 * direction of its PTG at several speeds within the dynamic window, and returns the cheapest.
 *
 * With a situation (BlindSpotReactiveNavigator gives one) it judges paths over the cost map.
 * Without, in MRPT's stock engine, it knows obstacles only as MRPT's collision-free distances and
 * drives straight to the target. Its parameters are bslnav's sections [dwa] and [limits] in MRPT's
 * INI file. Scores in the log record: exp(-J / 10), 0 for what is not
 * admissible; comparable from PTG to PTG. */
class CHolonomicDwa : public mrpt::nav::CAbstractHolonomicReactiveMethod {
  DEFINE_SERIALIZABLE(CHolonomicDwa, bslnav)

 public:
  CHolonomicDwa();

  void navigate(const NavInput& ni, NavOutput& no) override;
  /** @throws Error on a key that is unknown or a value out of range */
  void initialize(const mrpt::config::CConfigFileBase& file) override;
  void saveConfigFile(mrpt::config::CConfigFileBase& file) const override;
  double getTargetApproachSlowDownDistance() const override { return slowDownDistance_m_; }
  void setTargetApproachSlowDownDistance(const double distance) override {
    slowDownDistance_m_ = distance;
  }

  /** Parameters from a program that has them already, instead of initialize().
   *  @param evaluator may be shared by the methods of all PTGs of a robot */
  void use(const DwaParameters& parameters, const RobotLimits& limits, double controlPeriod_s,
           std::shared_ptr<CandidateEvaluator> evaluator);
  /** The situation of the next navigation step; null to judge by TP-obstacles alone. */
  void setSituation(const DwaSituation* situation) { situation_ = situation; }
  /** Every candidate of the last step, path by path, and the chosen one. */
  const DwaResult& result() const { return result_; }

 private:
  void makeOpenGround();
  void heed(const NavInput& ni, std::uint16_t k, double reach_m, Candidate& candidate) const;
  void evaluatePaths(const DwaInput& input, const NavInput* stock);

  DwaParameters parameters_;
  RobotLimits limits_;
  double controlPeriod_s_ = 0.1;
  double slowDownDistance_m_ = 0.01;
  std::shared_ptr<CandidateEvaluator> evaluator_;
  const DwaSituation* situation_ = nullptr;
  CostGrid openGround_;  // for the stock engine
  SampledPath path_;
  DwaResult result_;
};

}  // namespace bslnav
