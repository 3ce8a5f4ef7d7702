#pragma once

#include <bslnav/navigation/NavigatorParameters.h>
#include <bslnav/navigation/PtgNavigation.h>

#include <memory>

namespace bslnav {

/** MRPT's reactive navigation as a local planner: with CHolonomicDwa over the cost map, or as MRPT
 * ships it, for comparison.
 *
 * MRPT's engine sees the lethal cells of the cost map as its obstacles and the local goal as its
 * target. */
class ReactivePlanner : public LocalPlanner {
 public:
  /** @throws Error when MRPT does not take the configuration */
  ReactivePlanner(const NavigatorParameters& parameters, const DwaParameters& dwa,
                  const RobotLimits& limits, const FootprintCover& cover,
                  const Footprint& footprint, double controlPeriod_s);
  ~ReactivePlanner() override;

  const DwaResult& plan(const DwaInput& input, const CostGrid& costs) override;
  void reset() override;

 private:
  class Robot;
  void navigateTo(const DwaInput& input);

  RobotLimits limits_;
  double controlPeriod_s_;
  std::unique_ptr<Robot> robot_;
  std::unique_ptr<PtgNavigation> navigation_;
  DwaResult result_;
};

}  // namespace bslnav
