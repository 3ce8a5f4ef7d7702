#pragma once

#include <bslnav/simulation/WorldShape.h>
#include <mrpt/math/TPoint3D.h>

#include <array>
#include <memory>
#include <vector>

namespace bslnav {

/** Eight directions from one origin, unit vectors in the map frame. */
struct RayPacket {
  static constexpr int kSize = 8;
  alignas(32) std::array<float, kSize> x, y, z;
};

/** A picture's rays from one origin, map frame: pixel (u, v) looks along columns[u] + rows[v].
 *
 * Directions need no unit length: a hit is counted in lengths of its direction. If they are 1 m
 * long along a camera's axis, it is a depth [m]. */
struct RayImage {
  mrpt::math::TPoint3Df origin;
  std::vector<mrpt::math::TPoint3Df> columns;  ///< from left to right
  std::vector<RayPacket> rows;                 ///< eight each from top to bottom, filled up
  std::vector<float> hits;                     ///< row by row, also those that fill up
};

/** The world as rays see it: solids and the floor z = 0 stand still, people (cylinders) move.
 *
 * Only the solids are in Embree's tree, which is built once. Distances do not depend on the number
 * of threads; scenes share nothing, so each thread may have its own. Round solids are prisms within
 * 0.5 mm of the circle.
 */
class RayScene {
 public:
  struct Person {
    double radius_m, height_m;
  };

  /** People stand at the origin until placed.
   *  @throws Error on a bad world, or when the ray caster cannot be started */
  RayScene(const WorldParameters& world, const std::vector<Person>& people);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /** Moves all people, in the order given to the constructor; map frame. */
  void placePeople(const std::vector<mrpt::math::TPoint2D>& positions);

  /** Distance [m] along a unit direction to the first surface; infinity beyond `maxRange_m`. */
  float rayHit(const mrpt::math::TPoint3Df& origin, const mrpt::math::TPoint3Df& direction,
               float maxRange_m) const;
  /** The same for eight rays at once. */
  std::array<float, RayPacket::kSize> rayHits(const mrpt::math::TPoint3Df& origin,
                                              const RayPacket& directions, float maxRange_m) const;
  /** Sends all rays of a picture and writes their hits; infinity beyond `limit` direction lengths.
   *
   *  Takes memory only when the picture has none of its size yet. */
  void trace(RayImage& image, float limit) const;

 private:
  struct Embree;  // keeps the ray caster's headers out of ours
  std::unique_ptr<Embree> embree_;
};

}  // namespace bslnav
