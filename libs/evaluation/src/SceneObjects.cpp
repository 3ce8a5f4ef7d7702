#include "SceneObjects.h"

#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/CDisk.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CPolyhedron.h>

#include <cmath>

namespace bslnav::scene {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose3D;

mrpt::img::TColor toMrpt(Colour colour, double opacity = 1.0) {
  return {colour.r, colour.g, colour.b, static_cast<std::uint8_t>(std::lround(255.0 * opacity))};
}

/* MRPT draws translucent objects by the distance of their poses, so these are in their middle. */
Object prism(std::vector<TPoint2D> base, const TPoint2D& centre, double zMin_m, double zMax_m,
             Colour colour, double opacity) {
  for (TPoint2D& corner : base) corner -= centre;
  auto object = mrpt::opengl::CPolyhedron::CreateCustomPrism(base, zMax_m - zMin_m);
  object->setPose(TPose3D(centre.x, centre.y, zMin_m, 0.0, 0.0, 0.0));
  object->setColor_u8(toMrpt(colour, opacity));
  return object;
}

}  // namespace

Object cylinder(const TPoint2D& centre, double radius_m, double zMin_m, double zMax_m,
                Colour colour, double opacity) {
  constexpr int kSlices = 32;
  const auto radius = static_cast<float>(radius_m);
  auto object =
      mrpt::opengl::CCylinder::Create(radius, radius, static_cast<float>(zMax_m - zMin_m), kSlices);
  object->setPose(TPose3D(centre.x, centre.y, zMin_m, 0.0, 0.0, 0.0));
  object->setColor_u8(toMrpt(colour, opacity));
  return object;
}

Object solid(const WorldShape& shape, Colour colour, double opacity) {
  if (shape.isCylinder())
    return cylinder(shape.centre, shape.radius_m, shape.zMin_m, shape.zMax_m, colour, opacity);
  return prism(shape.polygon, shape.centre, shape.zMin_m, shape.zMax_m, colour, opacity);
}

Object body(const mrpt::math::TPose2D& pose, const Footprint& footprint, Colour colour) {
  constexpr double kHeight_m = 0.3;
  if (footprint.isCircle())
    return cylinder({pose.x, pose.y}, footprint.radius_m, 0.0, kHeight_m, colour);
  std::vector<TPoint2D> corners;
  for (const TPoint2D& corner : footprint.polygon) corners.push_back(pose.composePoint(corner));
  return prism(corners, {pose.x, pose.y}, 0.0, kHeight_m, colour, 1.0);
}

Object disc(const TPoint2D& centre, double radius_m, double innerRadius_m, double z_m,
            Colour colour, double opacity) {
  auto object =
      mrpt::opengl::CDisk::Create(static_cast<float>(radius_m), static_cast<float>(innerRadius_m));
  object->setPose(TPose3D(centre.x, centre.y, z_m, 0.0, 0.0, 0.0));
  object->setColor_u8(toMrpt(colour, opacity));
  return object;
}

Object cloud(const std::vector<mrpt::math::TPoint3Df>& points, Colour colour, float size_px) {
  auto object = mrpt::opengl::CPointCloud::Create();
  for (const auto& point : points) object->insertPoint(point.x, point.y, point.z);
  object->setPointSize(size_px);
  object->setColor_u8(toMrpt(colour));
  return object;
}

}  // namespace bslnav::scene
