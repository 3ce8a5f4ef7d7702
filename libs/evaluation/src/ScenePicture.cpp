#include <bslnav/evaluation/ScenePicture.h>
#include <mrpt/img/CImage.h>
#include <mrpt/opengl/CFBORender.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bslnav {
namespace {

constexpr double kFieldOfView_deg = 30.0;  // of the picture's height
constexpr double kAzimuth_deg = -97.0, kElevation_deg = 55.0;

Picture toPicture(const mrpt::img::CImage& image) {
  Picture picture;
  picture.width = static_cast<int>(image.getWidth());
  picture.height = static_cast<int>(image.getHeight());
  const auto channel = [&image](int x, int y, unsigned c) {
    return *image.ptr<std::uint8_t>(static_cast<unsigned>(x), static_cast<unsigned>(y), c);
  };
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (const unsigned c : {2U, 1U, 0U})  // MRPT stores blue first
        picture.rgb.push_back(channel(x, y, c));
  return picture;
}

}  // namespace

mrpt::opengl::CCamera cameraFor(const mrpt::math::TBoundingBoxf& box, double aspect) {
  const double azimuth = kAzimuth_deg * M_PI / 180.0, elevation = kElevation_deg * M_PI / 180.0;
  using mrpt::math::TPoint3D;
  const TPoint3D back(std::cos(azimuth) * std::cos(elevation),
                      std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const TPoint3D right(-std::sin(azimuth), std::cos(azimuth), 0.0);
  const TPoint3D up(-std::cos(azimuth) * std::sin(elevation),
                    -std::sin(azimuth) * std::sin(elevation), std::cos(elevation));
  const auto dot = [](const TPoint3D& a, const TPoint3D& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  };
  const TPoint3D centre((box.min.x + box.max.x) / 2.0, (box.min.y + box.max.y) / 2.0,
                        (box.min.z + box.max.z) / 2.0);
  const double slopeUp = std::tan(kFieldOfView_deg * M_PI / 360.0), slopeRight = slopeUp * aspect;
  double distance_m = 1.0;
  for (const float x : {box.min.x, box.max.x})
    for (const float y : {box.min.y, box.max.y})
      for (const float z : {box.min.z, box.max.z}) {
        const TPoint3D corner = TPoint3D(x, y, z) - centre;
        const double needed_m = std::max(std::abs(dot(corner, right)) / slopeRight,
                                         std::abs(dot(corner, up)) / slopeUp);
        distance_m = std::max(distance_m, needed_m + dot(corner, back));
      }
  mrpt::opengl::CCamera camera;
  camera.setProjectiveModel();
  camera.setProjectiveFOVdeg(static_cast<float>(kFieldOfView_deg));
  camera.setPointingAt(centre);
  camera.setAzimuthDegrees(static_cast<float>(kAzimuth_deg));
  camera.setElevationDegrees(static_cast<float>(kElevation_deg));
  camera.setZoomDistance(static_cast<float>(1.02 * distance_m));
  return camera;
}

RenderedScene renderScene(const mrpt::opengl::COpenGLScene& scene, int width_px,
                          int height_px) try {
  mrpt::opengl::CFBORender renderer(static_cast<unsigned>(width_px),
                                    static_cast<unsigned>(height_px));
  renderer.setCamera(scene, scene.getViewport()->getCamera());
  mrpt::img::CImage image;
  renderer.render_RGB(scene, image);
  return {toPicture(image), ""};
} catch (const std::exception&) {  // its text is MRPT's source line and a backtrace
  return {std::nullopt, "no OpenGL context could be made without a display (EGL)"};
}

}  // namespace bslnav
