#include <bslnav/costmap/FloorCheck.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace bslnav {
namespace {

constexpr double kTolerance_m = 0.1;
constexpr double kFewest = 0.1;  // a share of the points that is no accident
constexpr double kMost = 0.6;    // a share that makes a plane

double above(const mrpt::math::TPoint3Df& p, const FloorCheck::Plane& plane) {
  return static_cast<double>(p.z) - (plane.height_m + plane.rise_x * static_cast<double>(p.x) +
                                     plane.rise_y * static_cast<double>(p.y));
}

}  // namespace

/** Least squares over the points near a plane. */
FloorCheck::Plane FloorCheck::fitted(const Plane& guess, double within_m) const {
  Eigen::Matrix3d squares = 1e-6 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  for (const auto& p : points_) {
    if (std::abs(above(p, guess)) > within_m) continue;
    const Eigen::Vector3d row(1.0, static_cast<double>(p.x), static_cast<double>(p.y));
    squares += row * row.transpose();
    products += static_cast<double>(p.z) * row;
  }
  const Eigen::Vector3d plane = squares.ldlt().solve(products);
  return {plane[0], plane[1], plane[2]};
}

double FloorCheck::shareOf(const Plane& plane, double within_m) const {
  std::size_t near = 0;
  for (const auto& p : points_) near += std::abs(above(p, plane)) <= within_m;
  return static_cast<double>(near) / static_cast<double>(points_.size());
}

std::optional<FloorCheck::Plane> FloorCheck::misplacedFloor() const {
  if (points_.empty() || shareOf({0.0, 0.0, 0.0}, kTolerance_m) >= kFewest) return std::nullopt;
  const Plane all = fitted({0.0, 0.0, 0.0}, std::numeric_limits<double>::infinity());
  const Plane most = fitted(all, 3.0 * kTolerance_m);
  if (shareOf(most, kTolerance_m) < kMost) return std::nullopt;
  return most;
}

}  // namespace bslnav
