#include "DwaGenerators.h"

#include <cmath>

namespace bslnav::test {

using mrpt::math::TPose2D;

RobotLimits anyHolonomicLimits() {
  RobotLimits limits = anyLimits();
  limits.maxLateralSpeed_mps = any(0.1, limits.maxSpeed_mps);
  return limits;
}

mrpt::math::TTwist2D anyTwist(const RobotLimits& limits) {
  const double side = limits.maxLateralSpeed_mps, top = limits.maxSpeed_mps;
  const double vy = side > 0.0 ? any(-side, side) : 0.0;
  const double vx = std::sqrt(top * top - vy * vy);
  return {any(-vx, vx), vy, any(-limits.maxYawRate_radps, limits.maxYawRate_radps)};
}

RolloutSetup anySetup() {
  RolloutSetup setup;
  setup.start = {any(-1.0, 1.0), any(-1.0, 1.0), any(-M_PI, M_PI)};
  setup.horizon_s = any(0.5, 5.0);
  setup.step_s = any(0.02, 0.3);
  setup.allowUnknown = *rc::gen::arbitrary<bool>();
  return setup;
}

TPose2D onArc(const TPose2D& start, double v, double w, double t) {
  if (std::abs(w) < 1e-6)
    return {start.x + v * t * std::cos(start.phi), start.y + v * t * std::sin(start.phi),
            start.phi};
  const double r = v / w, phi = start.phi + w * t;
  return {start.x + r * (std::sin(phi) - std::sin(start.phi)),
          start.y - r * (std::cos(phi) - std::cos(start.phi)), phi};
}

TPose2D onArc(const TPose2D& start, const mrpt::math::TTwist2D& twist, double t) {
  const double w = twist.omega;
  if (std::abs(w) < 1e-6) {
    const double c = std::cos(start.phi), s = std::sin(start.phi);
    return {start.x + t * (c * twist.vx - s * twist.vy),
            start.y + t * (s * twist.vx + c * twist.vy), start.phi};
  }
  // The integrals of cosine and sine of the heading, turned by it.
  const double phi = start.phi + w * t;
  const double c = (std::sin(phi) - std::sin(start.phi)) / w;
  const double s = (std::cos(start.phi) - std::cos(phi)) / w;
  return {start.x + c * twist.vx - s * twist.vy, start.y + s * twist.vx + c * twist.vy, phi};
}

CostGrid freeSpace() { return CostGrid(240, 240, 0.05, -6.0, -6.0); }

CostGrid wallFrom(double x_m, Cost cost) {
  CostGrid grid = freeSpace();
  for (int y = 0; y < grid.height(); ++y)
    for (int x = grid.cellX(x_m); x < grid.width(); ++x) grid.at(x, y) = cost;
  return grid;
}

CostGrid scattered(int obstacles, int size) {
  CostGrid grid(size, size, 0.05, -0.025 * size, -0.025 * size);
  const auto cell = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, size));
  const int count = *rc::gen::inRange(0, obstacles + 1);
  for (int i = 0; i < count; ++i) {
    const int x = *cell, y = *cell;
    grid.at(x, y) = kLethalCost;
  }
  return grid;
}

CostGrid inflated(const CostGrid& base, const InflationLayer& inflation) {
  CostGrid costs = base;
  InflationLayer(inflation).apply(base, base.bounds(), costs);
  return costs;
}

std::vector<mrpt::math::TPoint2D> straightPath(double length_m) {
  std::vector<mrpt::math::TPoint2D> path;
  for (int i = 0; 0.05 * i < length_m + 1e-9; ++i) path.emplace_back(0.05 * i, 0.0);
  return path;
}

Footprint rectangle(double length_m, double width_m) {
  const double x = 0.5 * length_m, y = 0.5 * width_m;
  return {0.0, {{x, y}, {-x, y}, {-x, -y}, {x, -y}}};
}

InflationLayer noInflation() { return InflationLayer({0.0, 1.0}, 0.0, 0.05); }

}  // namespace bslnav::test
