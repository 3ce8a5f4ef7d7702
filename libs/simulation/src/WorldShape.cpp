#include <bslnav/simulation/WorldShape.h>

#include <algorithm>
#include <limits>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

WorldShape rectangle(const TPose2D& pose, double length_m, double width_m) {
  const double x = length_m / 2, y = width_m / 2;
  WorldShape shape;
  shape.centre = {pose.x, pose.y};
  shape.radius_m = std::hypot(x, y);
  for (const TPoint2D corner : {TPoint2D{-x, -y}, {x, -y}, {x, y}, {-x, y}})
    shape.polygon.push_back(pose.composePoint(corner));
  return shape;
}

template <typename Parameters>
void add(std::vector<WorldShape>& shapes, WorldShape shape, const std::string& section,
         const Parameters& parameters) {
  shape.section = section;
  shape.zMin_m = parameters.zMin_m;
  shape.zMax_m = parameters.zMax_m;
  shape.mapped = parameters.mapped;
  shapes.push_back(std::move(shape));
}

void addWall(std::vector<WorldShape>& shapes, const std::string& section,
             const WallParameters& wall) {
  const auto& points = wall.points_m;
  const double half_m = wall.thickness_m / 2;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const TPoint2D along = (points[i] - points[i - 1]).unitarize();
    const TPoint2D from = points[i - 1];
    const TPoint2D to = i + 1 == points.size() ? points[i] : points[i] + along * half_m;
    const TPoint2D middle = (from + to) * 0.5;
    add(shapes,
        rectangle({middle.x, middle.y, std::atan2(along.y, along.x)}, (to - from).norm(),
                  wall.thickness_m),
        section, wall);
  }
}

}  // namespace

std::vector<WorldShape> worldShapes(const WorldParameters& world) {
  world.check();
  std::vector<WorldShape> shapes;
  for (const auto& [name, wall] : world.walls) addWall(shapes, "wall:" + name, wall);
  for (const auto& [name, box] : world.boxes)
    add(shapes, rectangle(box.pose, box.length_m, box.width_m), "box:" + name, box);
  for (const auto& [name, cylinder] : world.cylinders) {
    WorldShape shape;
    shape.centre = {cylinder.x_m, cylinder.y_m};
    shape.radius_m = cylinder.radius_m;
    add(shapes, std::move(shape), "cylinder:" + name, cylinder);
  }
  return shapes;
}

WorldBounds worldBounds(const WorldParameters& world) {
  constexpr double kFar = std::numeric_limits<double>::max();
  WorldBounds bounds{{kFar, kFar}, {-kFar, -kFar}};
  const auto include = [&bounds](const TPoint2D& p, double radius_m) {
    bounds.lower = {std::min(bounds.lower.x, p.x - radius_m),
                    std::min(bounds.lower.y, p.y - radius_m)};
    bounds.upper = {std::max(bounds.upper.x, p.x + radius_m),
                    std::max(bounds.upper.y, p.y + radius_m)};
  };
  for (const auto& shape : worldShapes(world)) {
    if (shape.isCylinder()) include(shape.centre, shape.radius_m);
    for (const auto& corner : shape.polygon) include(corner, 0.0);
  }
  for (const auto& [name, person] : world.pedestrians)
    for (const auto& p : person.path_m) include(p, person.radius_m);
  if (bounds.lower.x > bounds.upper.x) return {};
  return bounds;
}

}  // namespace bslnav
