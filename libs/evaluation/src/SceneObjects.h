#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/Footprint.h>
#include <bslnav/pictures/ColourMap.h>
#include <bslnav/simulation/WorldShape.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/opengl/CRenderizable.h>

#include <vector>

namespace bslnav::scene {

using Object = mrpt::opengl::CRenderizable::Ptr;

/** @param opacity 0 to 1 */
Object solid(const WorldShape& shape, Colour colour, double opacity);
Object cylinder(const mrpt::math::TPoint2D& centre, double radius_m, double zMin_m, double zMax_m,
                Colour colour, double opacity = 1.0);
/** The robot's outline as a low body. */
Object body(const mrpt::math::TPose2D& pose, const Footprint& footprint, Colour colour);
/** A ring on the floor; a disc with an inner radius of 0. */
Object disc(const mrpt::math::TPoint2D& centre, double radius_m, double innerRadius_m, double z_m,
            Colour colour, double opacity = 1.0);
/** A polyline as a flat ribbon: OpenGL draws lines one pixel wide. */
Object ribbon(const std::vector<mrpt::math::TPoint2D>& points, double width_m, double z_m,
              Colour colour);
Object cloud(const std::vector<mrpt::math::TPoint3Df>& points, Colour colour, float size_px);
/** Costs as coloured rectangles on the floor, one for each run of equal cells in a row.
 *
 * A textured plane would be simpler, but MRPT draws textures after all else, so that they do not
 * show through what is translucent. */
Object costMesh(const CostGrid& costs);

/** The greater cost of two aligned grids, over the first one's extent; what one does not know says
 * the other. */
CostGrid merged(CostGrid costs, const CostGrid& more);

}  // namespace bslnav::scene
