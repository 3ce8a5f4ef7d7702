#include "SceneObjects.h"

#include <bslnav/pictures/PictureStyle.h>
#include <mrpt/img/CImage.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/CDisk.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CPolyhedron.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CTexturedPlane.h>

#include <algorithm>
#include <cmath>

namespace bslnav::scene {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose3D;

mrpt::img::TColor toMrpt(Colour colour, double opacity = 1.0) {
  return {colour.r, colour.g, colour.b, static_cast<std::uint8_t>(std::lround(255.0 * opacity))};
}

Object prism(const std::vector<TPoint2D>& base, double zMin_m, double zMax_m, Colour colour,
             double opacity) {
  auto object = mrpt::opengl::CPolyhedron::CreateCustomPrism(base, zMax_m - zMin_m);
  object->setPose(TPose3D(0.0, 0.0, zMin_m, 0.0, 0.0, 0.0));
  object->setColor_u8(toMrpt(colour, opacity));
  return object;
}

Colour colourOf(Cost cost) {
  switch (cost) {
    case kFreeCost:
      return palette::kWhite;
    case kInscribedCost:
      return palette::kInscribed;
    case kLethalCost:
      return palette::kLethal;
    case kUnknownCost:
      return palette::kUnknown;
    default:
      return colourAt(ColourMap::CellCost, double{cost} / kHighestGradedCost);
  }
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
  return prism(shape.polygon, shape.zMin_m, shape.zMax_m, colour, opacity);
}

Object body(const mrpt::math::TPose2D& pose, const Footprint& footprint, Colour colour) {
  constexpr double kHeight_m = 0.3;
  if (footprint.isCircle())
    return cylinder({pose.x, pose.y}, footprint.radius_m, 0.0, kHeight_m, colour);
  std::vector<TPoint2D> corners;
  for (const TPoint2D& corner : footprint.polygon) corners.push_back(pose.composePoint(corner));
  return prism(corners, 0.0, kHeight_m, colour, 1.0);
}

Object disc(const TPoint2D& centre, double radius_m, double innerRadius_m, double z_m,
            Colour colour, double opacity) {
  auto object =
      mrpt::opengl::CDisk::Create(static_cast<float>(radius_m), static_cast<float>(innerRadius_m));
  object->setPose(TPose3D(centre.x, centre.y, z_m, 0.0, 0.0, 0.0));
  object->setColor_u8(toMrpt(colour, opacity));
  return object;
}

Object line(const std::vector<TPoint2D>& points, double z_m, Colour colour, float width_px) {
  auto object = mrpt::opengl::CSetOfLines::Create();
  const auto z = static_cast<float>(z_m);
  const auto x = [&](std::size_t i) { return static_cast<float>(points[i].x); };
  const auto y = [&](std::size_t i) { return static_cast<float>(points[i].y); };
  for (std::size_t i = 1; i < points.size(); ++i)
    object->appendLine(x(i - 1), y(i - 1), z, x(i), y(i), z);
  object->setLineWidth(width_px);
  object->setColor_u8(toMrpt(colour));
  return object;
}

Object cloud(const std::vector<mrpt::math::TPoint3Df>& points, Colour colour, float size_px) {
  auto object = mrpt::opengl::CPointCloud::Create();
  for (const auto& point : points) object->insertPoint(point.x, point.y, point.z);
  object->setPointSize(size_px);
  object->setColor_u8(toMrpt(colour));
  return object;
}

Object costPlane(const CostGrid& costs) {
  const auto width = static_cast<unsigned>(costs.width());
  const auto height = static_cast<unsigned>(costs.height());
  std::vector<std::uint8_t> rgb;
  rgb.reserve(std::size_t{3} * width * height);
  for (int y = 0; y < costs.height(); ++y)
    for (int x = 0; x < costs.width(); ++x) {
      const Colour colour = colourOf(costs.at(x, y));
      rgb.insert(rgb.end(), {colour.r, colour.g, colour.b});
    }
  mrpt::img::CImage image;
  image.loadFromMemoryBuffer(width, height, mrpt::img::CH_RGB, rgb.data(), true);
  const auto f = [](double value) { return static_cast<float>(value); };
  auto plane = mrpt::opengl::CTexturedPlane::Create(f(costs.getXMin()), f(costs.getXMax()),
                                                    f(costs.getYMin()), f(costs.getYMax()));
  plane->assignImage(image);
  return plane;
}

CostGrid merged(CostGrid costs, const CostGrid& more) {
  for (int y = 0; y < costs.height(); ++y)
    for (int x = 0; x < costs.width(); ++x) {
      Cost& cost = costs.at(x, y);
      const Cost other = more.costAt(costs.idx2x(x), costs.idx2y(y));
      if (other == kUnknownCost) continue;
      cost = cost == kUnknownCost ? other : std::max(cost, other);
    }
  return costs;
}

}  // namespace bslnav::scene
