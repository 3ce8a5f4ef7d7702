#include <bslnav/config/Error.h>
#include <bslnav/simulation/RayScene.h>

#include <cstring>

#include "ExtrudedMesh.h"
#include "RaySceneEmbree.h"

namespace bslnav {
namespace {

using Scene = OwnedHandle<RTCScene, rtcReleaseScene>;
using Geometry = OwnedHandle<RTCGeometry, rtcReleaseGeometry>;

template <typename Item>
void copyToBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                  const std::vector<Item>& items) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), items.size());
  std::memcpy(buffer, items.data(), items.size() * sizeof(Item));
}

Scene meshScene(RTCDevice device, const ExtrudedMesh& mesh) {
  Scene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  if (!mesh.triangles.empty()) {
    const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    copyToBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
    copyToBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene.get(), geometry.get());
  }
  rtcCommitScene(scene.get());
  return scene;
}

}  // namespace

RayScene::RayScene(const WorldParameters& world, const std::vector<Person>& people)
    : embree_(std::make_unique<Embree>()) {
  const RTCDevice device = embree_->device.get();
  if (!device)
    throw Error("simulation", "the ray caster (Embree) could not be started", Error::Kind::Run);
  ExtrudedMesh mesh;
  for (const auto& shape : worldShapes(world)) mesh.add(shape);
  embree_->solids = meshScene(device, mesh);
  for (const auto& person : people)
    embree_->people.push_back(
        {0.0f, 0.0f, static_cast<float>(person.radius_m), static_cast<float>(person.height_m)});
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw Error("simulation", "the ray caster (Embree) refused the world", Error::Kind::Run);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

void RayScene::placePeople(const std::vector<mrpt::math::TPoint2D>& positions) {
  for (std::size_t i = 0; i < embree_->people.size(); ++i) {
    embree_->people[i].x = static_cast<float>(positions.at(i).x);
    embree_->people[i].y = static_cast<float>(positions.at(i).y);
  }
}

}  // namespace bslnav
