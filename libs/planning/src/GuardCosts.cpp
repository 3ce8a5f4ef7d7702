#include <bslnav/planning/GuardCosts.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace bslnav {
namespace {

/** The cells from which the frontier slows the robot down. */
CellWindow windowOf(const Frontier& frontier, int reach, const CostGrid& costs) {
  CellWindow window;
  for (const FrontierPoint& p : frontier) {
    const int x = costs.cellX(p.x_m), y = costs.cellY(p.y_m);
    window = window.united({x, y, x + 1, y + 1});
  }
  return window.grown(reach).intersected(costs.bounds());
}

Cost costAt(double distance_m, double standing_m, double full_m, double costWeight) {
  if (distance_m >= full_m) return kFreeCost;
  if (distance_m <= standing_m) return kHighestGradedCost;
  const double slowness = (full_m - standing_m) / (distance_m - standing_m);
  const double cost = (slowness - 1.0) * kHighestGradedCost / std::max(costWeight, 1e-9);
  return static_cast<Cost>(std::min<double>(cost, kHighestGradedCost));
}

}  // namespace

void addGuardCosts(const Frontier& frontier, const GuardParameters& guard,
                   const StoppingAbility& robot, double maxSpeed_mps, double costWeight,
                   CostGrid& costs) {
  const double standing_m =
      robot.radius_m + guard.margin_m + guard.personSpeed_mps * robot.reaction_s;
  const double full_m = standing_m + guard.personSpeed_mps * maxSpeed_mps / robot.deceleration_mps2;
  const double cell_m = costs.getResolution();
  const CellWindow window = windowOf(frontier, static_cast<int>(std::ceil(full_m / cell_m)), costs);
  if (window.empty()) return;
  cv::Mat away(window.height(), window.width(), CV_8U, cv::Scalar(1)), distance;
  for (const FrontierPoint& p : frontier) {
    const int x = costs.cellX(p.x_m), y = costs.cellY(p.y_m);
    if (window.contains(x, y)) away.at<unsigned char>(y - window.y0, x - window.x0) = 0;
  }
  cv::distanceTransform(away, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      Cost& cost = costs.at(x, y);
      if (cost > kHighestGradedCost) continue;
      const double distance_m = cell_m * distance.at<float>(y - window.y0, x - window.x0);
      cost = std::max(cost, costAt(distance_m, standing_m, full_m, costWeight));
    }
}

}  // namespace bslnav
