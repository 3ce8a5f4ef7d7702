#pragma once

#include <bslnav/pictures/Picture.h>
#include <mrpt/math/TBoundingBox.h>
#include <mrpt/opengl/CCamera.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <optional>
#include <string>

namespace bslnav {

/** A camera that looks at a box from above at an angle, as near as it can with the whole of it in
 * view. @param aspect width over height of the picture */
mrpt::opengl::CCamera cameraFor(const mrpt::math::TBoundingBoxf& box, double aspect);

/** A picture of a scene, or why there is none. */
struct RenderedScene {
  std::optional<Picture> picture;
  std::string problem;
};

/** Renders a scene as its camera sees it, without a display; needs EGL. */
RenderedScene renderScene(const mrpt::opengl::COpenGLScene& scene, int width_px, int height_px);

}  // namespace bslnav
