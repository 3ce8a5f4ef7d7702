#include <bslnav/config/Error.h>
#include <bslnav/simulation/RayScene.h>
#include <embree3/rtcore.h>

#include <cstring>
#include <limits>

#include "ExtrudedMesh.h"

namespace bslnav {
namespace {

template <typename Handle, void (*release)(Handle)>
struct Release {
  void operator()(Handle handle) const { release(handle); }
};
template <typename Handle, void (*release)(Handle)>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release<Handle, release>>;
using Device = Owned<RTCDevice, rtcReleaseDevice>;
using Scene = Owned<RTCScene, rtcReleaseScene>;
using Geometry = Owned<RTCGeometry, rtcReleaseGeometry>;

constexpr float kNoHit = std::numeric_limits<float>::infinity();
constexpr double kFloorMargin_m = 100.0;  // farther than a sensor on the robot sees
constexpr double kUnitRoundness = 0.002;  // of a circle of radius 1: 0.5 mm of a person's 0.25 m

template <typename Item>
void copyToBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                  const std::vector<Item>& items) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), items.size());
  std::memcpy(buffer, items.data(), items.size() * sizeof(Item));
}

Scene meshScene(RTCDevice device, const ExtrudedMesh& mesh) {
  Scene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  copyToBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
  copyToBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  return scene;
}

Geometry instanceOf(RTCDevice device, RTCScene scene, RTCScene parent) {
  Geometry instance(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(instance.get(), scene);
  rtcCommitGeometry(instance.get());
  rtcAttachGeometry(parent, instance.get());
  return instance;
}

/** Scales the unit cylinder to a person and moves it. */
void transform(RTCGeometry instance, const RayScene::Person& person,
               const mrpt::math::TPoint2D& position) {
  const auto radius = static_cast<float>(person.radius_m),
             height = static_cast<float>(person.height_m);
  const auto x = static_cast<float>(position.x), y = static_cast<float>(position.y);
  const float columns[12] = {radius, 0, 0, 0, radius, 0, 0, 0, height, x, y, 0};
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
  rtcCommitGeometry(instance);
}

}  // namespace

struct RayScene::Embree {
  // Not "threads=1": while such a device lives, TBB has one thread in the whole process.
  Device device{rtcNewDevice(nullptr)};
  Scene world, person, all;
  std::vector<Person> people;
  std::vector<Geometry> instances;
};

RayScene::RayScene(const WorldParameters& world, const std::vector<Person>& people)
    : embree_(std::make_unique<Embree>()) {
  const RTCDevice device = embree_->device.get();
  if (!device)
    throw Error("simulation", "the ray caster (Embree) could not be started", Error::Kind::Run);
  ExtrudedMesh solids, cylinder;
  for (const auto& shape : worldShapes(world)) solids.add(shape);
  solids.addFloor(worldBounds(world), kFloorMargin_m);
  cylinder.add(circlePolygon({0.0, 0.0}, 1.0, kUnitRoundness), 0.0, 1.0);
  embree_->world = meshScene(device, solids);
  embree_->person = meshScene(device, cylinder);
  embree_->all.reset(rtcNewScene(device));
  rtcSetSceneFlags(embree_->all.get(),
                   static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST));
  instanceOf(device, embree_->world.get(), embree_->all.get());
  embree_->people = people;
  for (std::size_t i = 0; i < people.size(); ++i)
    embree_->instances.push_back(instanceOf(device, embree_->person.get(), embree_->all.get()));
  placePeople(std::vector<mrpt::math::TPoint2D>(people.size()));
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw Error("simulation", "the ray caster (Embree) refused the world", Error::Kind::Run);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

void RayScene::placePeople(const std::vector<mrpt::math::TPoint2D>& positions) {
  for (std::size_t i = 0; i < embree_->instances.size(); ++i)
    transform(embree_->instances[i].get(), embree_->people[i], positions.at(i));
  rtcCommitScene(embree_->all.get());
}

float RayScene::rayHit(const mrpt::math::TPoint3Df& origin, const mrpt::math::TPoint3Df& direction,
                       float maxRange_m) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray = {origin.x,    origin.y, origin.z,   0,   direction.x, direction.y,
             direction.z, 0,        maxRange_m, ~0U, 0,           0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->all.get(), &context, &ray);
  return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kNoHit : ray.ray.tfar;
}

std::array<float, RayPacket::kSize> RayScene::rayHits(const mrpt::math::TPoint3Df& origin,
                                                      const RayPacket& directions,
                                                      float maxRange_m) const {
  alignas(32) static constexpr int kAllValid[RayPacket::kSize] = {-1, -1, -1, -1, -1, -1, -1, -1};
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit8 rays{};
  for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
    rays.ray.org_x[i] = origin.x;
    rays.ray.org_y[i] = origin.y;
    rays.ray.org_z[i] = origin.z;
    rays.ray.dir_x[i] = directions.x[i];
    rays.ray.dir_y[i] = directions.y[i];
    rays.ray.dir_z[i] = directions.z[i];
    rays.ray.tfar[i] = maxRange_m;
    rays.ray.mask[i] = ~0U;
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(kAllValid, embree_->all.get(), &context, &rays);
  std::array<float, RayPacket::kSize> distances;
  for (std::size_t i = 0; i < RayPacket::kSize; ++i)
    distances[i] = rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kNoHit : rays.ray.tfar[i];
  return distances;
}

}  // namespace bslnav
