#include <bslnav/config/VectorClones.h>
#include <bslnav/simulation/RayScene.h>

#include <algorithm>
#include <limits>

#include "RaySceneEmbree.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint3Df;

constexpr std::size_t kSize = RayPacket::kSize;
constexpr std::size_t kTogether = 16;  // packets of a picture in one call

/** Where a ray comes to the floor z = 0; `limit` when that is nearer. */
inline float floorHit(float originZ, float directionZ, float limit) {
  const float t = -originZ / directionZ;  // infinite or NaN for a level ray
  const float ahead = t > 0.0f ? t : limit;
  return ahead < limit ? ahead : limit;
}

/** Points eight rays along `column` + `rows`, as far as the floor or `limit`. */
BSLNAV_VECTOR_CLONES void aimAtFloor(const TPoint3Df& column, const RayPacket& rows, float limit,
                                     RTCRay8& rays) {
  const float x = column.x, y = column.y, z = column.z;
  for (std::size_t i = 0; i < kSize; ++i) {
    const float up = rows.z[i] + z;
    rays.dir_x[i] = rows.x[i] + x;
    rays.dir_y[i] = rows.y[i] + y;
    rays.dir_z[i] = up;
    rays.tfar[i] = floorHit(rays.org_z[i], up, limit);
  }
}

float hitOrNothing(float t, float limit) {
  return t < limit ? t : std::numeric_limits<float>::infinity();
}

/** Casts up to `kPackets` packets at a time from one origin. */
template <std::size_t kPackets>
class PacketCaster {
 public:
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

  /** Points one of the packets along `column` + `rows`. Floor and people come first: what is near
   * spares the search for solids behind it. */
  void aim(std::size_t packet, const TPoint3Df& column, const RayPacket& rows) {
    RTCRay8& rays = rays_[packet].ray;
    aimAtFloor(column, rows, limit_, rays);
    for (const auto& person : people_)
      if (person.mayBeHitBy(origin_, rays.dir_x, rays.dir_y))
        for (std::size_t i = 0; i < kSize; ++i)
          rays.tfar[i] =
              person.hit(origin_, {rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]}, rays.tfar[i]);
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
  PacketCaster<1> caster(embree_->solids.get(), embree_->people, origin, maxRange_m);
  caster.aim(0, {}, directions);
  caster.cast(1);
  std::array<float, kSize> hits;
  for (std::size_t i = 0; i < kSize; ++i) hits[i] = caster.hit(0, i);
  return hits;
}

void RayScene::trace(RayImage& image, float limit) const {
  PacketCaster<kTogether> caster(embree_->solids.get(), embree_->people, image.origin, limit);
  const std::size_t width = image.columns.size();
  image.hits.resize(image.rows.size() * kSize * width);
  float* row = image.hits.data();
  for (const auto& rows : image.rows) {
    for (std::size_t first = 0; first < width; first += kTogether) {
      const std::size_t packets = std::min(kTogether, width - first);
      for (std::size_t p = 0; p < packets; ++p) caster.aim(p, image.columns[first + p], rows);
      caster.cast(packets);
      for (std::size_t i = 0; i < kSize; ++i)
        for (std::size_t p = 0; p < packets; ++p) row[i * width + first + p] = caster.hit(p, i);
    }
    row += kSize * width;
  }
}

}  // namespace bslnav
