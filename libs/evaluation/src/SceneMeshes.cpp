#include <bslnav/pictures/PictureStyle.h>
#include <mrpt/opengl/CSetOfTriangles.h>

#include <algorithm>
#include <cmath>

#include "SceneObjects.h"

namespace bslnav::scene {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3Df;

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
      return colourAt(ColourMap::CellCost, static_cast<double>(cost) / kHighestGradedCost);
  }
}

/** Flat quadrilaterals at one height. */
class FlatMesh {
 public:
  explicit FlatMesh(double z_m) : z_(static_cast<float>(z_m)) {}

  /** Corners counterclockwise. */
  void add(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, const TPoint2D& d,
           Colour colour) {
    addTriangle(a, b, c, colour);
    addTriangle(a, c, d, colour);
  }
  const mrpt::opengl::CSetOfTriangles::Ptr& triangles() const { return triangles_; }

 private:
  void addTriangle(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, Colour colour) {
    const auto at = [this](const TPoint2D& p) {
      return TPoint3Df(static_cast<float>(p.x), static_cast<float>(p.y), z_);
    };
    mrpt::opengl::TTriangle triangle(at(a), at(b), at(c));
    triangle.setColor(mrpt::img::TColor(colour.r, colour.g, colour.b));
    triangles_->insertTriangle(triangle);
  }

  float z_;
  mrpt::opengl::CSetOfTriangles::Ptr triangles_ = mrpt::opengl::CSetOfTriangles::Create();
};

}  // namespace

Object ribbon(const std::vector<TPoint2D>& points, double width_m, double z_m, Colour colour) {
  FlatMesh mesh(z_m);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const TPoint2D &a = points[i - 1], &b = points[i], along = b - a;
    const double length_m = along.norm();
    if (length_m <= 0.0) continue;
    const TPoint2D left = TPoint2D(-along.y, along.x) * (0.5 * width_m / length_m);
    mesh.add(a - left, b - left, b + left, a + left, colour);
  }
  return mesh.triangles();
}

Object costMesh(const CostGrid& costs) {
  FlatMesh mesh(0.0);
  const double resolution_m = costs.getResolution();
  for (int y = 0; y < costs.height(); ++y) {
    const Cost* row = costs.row(y);
    const double y0 = costs.getYMin() + y * resolution_m, y1 = y0 + resolution_m;
    for (int x = 0, end = 0; x < costs.width(); x = end) {
      end = static_cast<int>(
          std::find_if(row + x, row + costs.width(), [&](Cost cost) { return cost != row[x]; }) -
          row);
      const double x0 = costs.getXMin() + x * resolution_m;
      const double x1 = costs.getXMin() + end * resolution_m;
      mesh.add({x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, colourOf(row[x]));
    }
  }
  // Behind everything, whichever way one looks down on it: drawn first.
  mesh.triangles()->setLocalRepresentativePoint({0.0f, 0.0f, -1000.0f});
  return mesh.triangles();
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
