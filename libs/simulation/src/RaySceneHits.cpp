#include <bslnav/simulation/RayScene.h>

#include <algorithm>
#include <limits>

#include "RaySceneEmbree.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint3Df;

constexpr std::size_t kSize = RayPacket::kSize;
alignas(32) constexpr int kAllValid[kSize] = {-1, -1, -1, -1, -1, -1, -1, -1};

/** Where a ray comes to the floor z = 0; `limit` when that is nearer. */
float floorHit(float originZ, float directionZ, float limit) {
  const float t = -originZ / directionZ;  // infinite or NaN for a level ray
  return (t > 0.0f) & (t < limit) ? t : limit;
}

float hitOrNothing(float t, float limit) {
  return t < limit ? t : std::numeric_limits<float>::infinity();
}

/** Casts a few packets at a time from one origin. */
class PacketCaster {
 public:
  static constexpr std::size_t kPackets = 8;

  PacketCaster(RTCScene solids, const std::vector<PersonCylinder>& people, const TPoint3Df& origin,
               float limit)
      : solids_(solids), people_(people), origin_(origin), limit_(limit) {
    rtcInitIntersectContext(&context_);
    context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (auto& rays : rays_)
      for (std::size_t i = 0; i < kSize; ++i) {
        rays.ray.org_x[i] = origin.x;
        rays.ray.org_y[i] = origin.y;
        rays.ray.org_z[i] = origin.z;
        rays.ray.mask[i] = ~0U;
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      }
  }

  /** Takes in the directions of one of the packets. Floor and people come first: what is near
   * spares the search for solids behind it. */
  void aim(std::size_t packet, const RayPacket& directions) {
    RTCRay8& rays = rays_[packet].ray;
    for (std::size_t i = 0; i < kSize; ++i) {
      rays.dir_x[i] = directions.x[i];
      rays.dir_y[i] = directions.y[i];
      rays.dir_z[i] = directions.z[i];
      rays.tfar[i] = floorHit(origin_.z, directions.z[i], limit_);
    }
    for (const auto& person : people_)
      if (person.mayBeHitBy(origin_, directions))
        for (std::size_t i = 0; i < kSize; ++i)
          rays.tfar[i] = person.hit(origin_, {directions.x[i], directions.y[i], directions.z[i]},
                                    rays.tfar[i]);
  }

  /** Finds the solids before floor and people for the first packets. */
  void cast(std::size_t packets) {
    rtcIntersectNM(solids_, &context_, reinterpret_cast<RTCRayHitN*>(rays_), kSize,
                   static_cast<unsigned>(packets), sizeof(RTCRayHit8));
  }

  /** How far a ray came; infinity beyond the limit. */
  float hit(std::size_t packet, std::size_t ray) const {
    return hitOrNothing(rays_[packet].ray.tfar[ray], limit_);
  }

 private:
  RTCScene solids_;
  const std::vector<PersonCylinder>& people_;
  TPoint3Df origin_;
  float limit_;
  RTCIntersectContext context_;
  RTCRayHit8 rays_[kPackets] = {};
};

RayPacket sum(const TPoint3Df& column, const RayPacket& rows) {
  RayPacket result = rows;
  for (std::size_t i = 0; i < kSize; ++i) {
    result.x[i] += column.x;
    result.y[i] += column.y;
    result.z[i] += column.z;
  }
  return result;
}

}  // namespace

float RayScene::rayHit(const TPoint3Df& origin, const TPoint3Df& direction,
                       float maxRange_m) const {
  float limit = floorHit(origin.z, direction.z, maxRange_m);
  for (const auto& person : embree_->people) limit = person.hit(origin, direction, limit);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray = {origin.x,    origin.y, origin.z, 0,   direction.x, direction.y,
             direction.z, 0,        limit,    ~0U, 0,           0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree_->solids.get(), &context, &ray);
  return hitOrNothing(ray.ray.tfar, maxRange_m);
}

std::array<float, kSize> RayScene::rayHits(const TPoint3Df& origin, const RayPacket& directions,
                                           float maxRange_m) const {
  PacketCaster caster(embree_->solids.get(), embree_->people, origin, maxRange_m);
  caster.aim(0, directions);
  caster.cast(1);
  std::array<float, kSize> hits;
  for (std::size_t i = 0; i < kSize; ++i) hits[i] = caster.hit(0, i);
  return hits;
}

void RayScene::trace(RayImage& image, float limit) const {
  PacketCaster caster(embree_->solids.get(), embree_->people, image.origin, limit);
  const std::size_t width = image.columns.size();
  image.hits.resize(image.rows.size() * kSize * width);
  float* row = image.hits.data();
  for (const auto& rows : image.rows) {
    for (std::size_t first = 0; first < width; first += PacketCaster::kPackets) {
      const std::size_t packets = std::min(PacketCaster::kPackets, width - first);
      for (std::size_t p = 0; p < packets; ++p) caster.aim(p, sum(image.columns[first + p], rows));
      caster.cast(packets);
      for (std::size_t i = 0; i < kSize; ++i)
        for (std::size_t p = 0; p < packets; ++p) row[i * width + first + p] = caster.hit(p, i);
    }
    row += kSize * width;
  }
}

}  // namespace bslnav
