#include <bslnav/simulation/RayScene.h>

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
  return t > 0.0f && t < limit ? t : limit;
}

float hitOrNothing(float t, float limit) {
  return t < limit ? t : std::numeric_limits<float>::infinity();
}

/** Casts packet after packet from one origin. */
class PacketCaster {
 public:
  PacketCaster(RTCScene solids, const std::vector<PersonCylinder>& people, const TPoint3Df& origin,
               float limit)
      : solids_(solids), people_(people), origin_(origin), limit_(limit) {
    rtcInitIntersectContext(&context_);
    context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t i = 0; i < kSize; ++i) {
      rays_.ray.org_x[i] = origin.x;
      rays_.ray.org_y[i] = origin.y;
      rays_.ray.org_z[i] = origin.z;
      rays_.ray.mask[i] = ~0U;
      rays_.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  /** How far the rays come; infinity beyond the limit. Floor and people first: what is near spares
   * the search for solids behind it. */
  std::array<float, kSize> hits(const RayPacket& directions) {
    for (std::size_t i = 0; i < kSize; ++i) {
      rays_.ray.dir_x[i] = directions.x[i];
      rays_.ray.dir_y[i] = directions.y[i];
      rays_.ray.dir_z[i] = directions.z[i];
      rays_.ray.tfar[i] = floorHit(origin_.z, directions.z[i], limit_);
    }
    for (const auto& person : people_)
      if (person.mayBeHitBy(origin_, directions)) see(person, directions);
    rtcIntersect8(kAllValid, solids_, &context_, &rays_);
    std::array<float, kSize> result;
    for (std::size_t i = 0; i < kSize; ++i) result[i] = hitOrNothing(rays_.ray.tfar[i], limit_);
    return result;
  }

 private:
  void see(const PersonCylinder& person, const RayPacket& directions) {
    for (std::size_t i = 0; i < kSize; ++i)
      rays_.ray.tfar[i] = person.hit(origin_, {directions.x[i], directions.y[i], directions.z[i]},
                                     rays_.ray.tfar[i]);
  }

  RTCScene solids_;
  const std::vector<PersonCylinder>& people_;
  TPoint3Df origin_;
  float limit_;
  RTCIntersectContext context_;
  RTCRayHit8 rays_{};
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
  return PacketCaster(embree_->solids.get(), embree_->people, origin, maxRange_m).hits(directions);
}

void RayScene::trace(RayImage& image, float limit) const {
  PacketCaster caster(embree_->solids.get(), embree_->people, image.origin, limit);
  const std::size_t width = image.columns.size();
  image.hits.resize(image.rows.size() * kSize * width);
  for (std::size_t strip = 0; strip < image.rows.size(); ++strip)
    for (std::size_t u = 0; u < width; ++u) {
      RayPacket directions = image.rows[strip];
      for (std::size_t i = 0; i < kSize; ++i) {
        directions.x[i] += image.columns[u].x;
        directions.y[i] += image.columns[u].y;
        directions.z[i] += image.columns[u].z;
      }
      const auto hits = caster.hits(directions);
      float* hit = &image.hits[strip * kSize * width + u];
      for (std::size_t i = 0; i < kSize; ++i) hit[i * width] = hits[i];
    }
}

}  // namespace bslnav
