#pragma once

#include <bslnav/planning/DwaPlanner.h>
#include <bslnav/planning/RobotLimits.h>
#include <rapidcheck.h>

namespace bslnav::test {

/** A number in [low, high]. */
inline double any(double low, double high) {
  return low +
         (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1000001)) / 1e6;
}

inline RobotLimits anyLimits() {
  return {any(0.2, 2.0), any(0.3, 2.0), any(0.1, 3.0), any(0.1, 3.0), any(0.3, 6.0)};
}

/** Limits of a robot that can move sideways. */
RobotLimits anyHolonomicLimits();

/** A twist within the limits, forwards or backwards. */
mrpt::math::TTwist2D anyTwist(const RobotLimits& limits);

/** Start near the origin, any horizon and step. */
RolloutSetup anySetup();

/** Where a constant velocity leads to in a time, by the textbook. */
mrpt::math::TPose2D onArc(const mrpt::math::TPose2D& start, double v, double w, double t);
/** The same with lateral motion. */
mrpt::math::TPose2D onArc(const mrpt::math::TPose2D& start, const mrpt::math::TTwist2D& twist,
                          double t);

/** 12 m × 12 m around the origin, free. */
CostGrid freeSpace();

/** The same with this cost in all cells from x_m on. */
CostGrid wallFrom(double x_m, Cost cost = kInscribedCost);

/** Cells of 0.05 m around the origin with up to `obstacles` lethal ones, not inflated. */
CostGrid scattered(int obstacles, int size = 120);

/** The same, inflated for a robot with this inscribed radius. */
CostGrid inflated(const CostGrid& base, const InflationLayer& inflation);

/** A straight path from the origin along x, 5 cm from point to point. */
std::vector<mrpt::math::TPoint2D> straightPath(double length_m);

/** A rectangle around the origin. */
Footprint rectangle(double length_m, double width_m);

/** Tells of every point whether it holds no lethal cell; for tests without inflation. */
InflationLayer noInflation();

}  // namespace bslnav::test
