#include <bslnav/config/Config.h>
#include <bslnav/simulation/RobotBody.h>

#include <algorithm>
#include <cmath>

#include "PlanarGeometry.h"

namespace bslnav {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

RobotBody::RobotBody(const RobotOutline& outline) : outline_(outline), placed_(outline.polygon) {
  if (!(outline.height_m > 0.0)) Config::refuse("robot", "height_m", "a number above 0");
  if (outline.polygon.empty() && !(outline.radius_m > 0.0))
    Config::refuse("robot", "radius_m", "a number above 0");
  if (!outline.polygon.empty() && outline.polygon.size() < 3)
    Config::refuse("robot", "polygon_m", "at least three corners, or none for a circle");
  if (outline.polygon.empty()) reach_m_ = outline.radius_m;
  for (const auto& corner : outline.polygon) reach_m_ = std::max(reach_m_, corner.norm());
}

void RobotBody::moveTo(const mrpt::math::TPose2D& mapFromRobot) {
  pose_ = mapFromRobot;
  const double c = std::cos(pose_.phi), s = std::sin(pose_.phi);
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const auto& p = outline_.polygon[i];
    placed_[i] = {pose_.x + c * p.x - s * p.y, pose_.y + s * p.x + c * p.y};
  }
}

double RobotBody::distanceTo(const mrpt::math::TPoint2D& p) const {
  if (!placed_.empty()) return distanceToPolygon(p, placed_);
  return std::hypot(p.x - pose_.x, p.y - pose_.y) - outline_.radius_m;
}

double RobotBody::clearanceTo(const mrpt::math::TPoint2D& centre, double radius_m) const {
  return distanceTo(centre) - radius_m;
}

double RobotBody::clearanceTo(const WorldShape& shape) const {
  if (shape.zMin_m >= outline_.height_m) return kFar;
  if (shape.isCylinder()) return clearanceTo(shape.centre, shape.radius_m);
  if (placed_.empty())
    return distanceToPolygon({pose_.x, pose_.y}, shape.polygon) - outline_.radius_m;
  return distanceBetweenPolygons(placed_, shape.polygon);
}

double RobotBody::clearanceTo(const std::vector<WorldShape>& shapes) const {
  double nearest = kFar;
  for (const auto& shape : shapes) {
    const double atLeast =
        std::hypot(shape.centre.x - pose_.x, shape.centre.y - pose_.y) - shape.radius_m - reach_m_;
    if (atLeast < nearest) nearest = std::min(nearest, clearanceTo(shape));
  }
  return nearest;
}

}  // namespace bslnav
