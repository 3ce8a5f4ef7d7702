#pragma once

#include <bslnav/costmap/PlanarScan.h>
#include <mrpt/math/TPoint2D.h>

#include <array>
#include <vector>

namespace bslnav {

/** How far a scan sees in every direction, and the surfaces at which its view ends.
 *
 * Neighbouring hits that are nearer to each other than a person is wide belong to one surface;
 * between all other neighbours the view reaches as far as the nearer one. A dropped beam is as if
 * it were not there, and so are one or two beams without return between others. */
class ScanView {
 public:
  static constexpr int kDirections = 2048;  ///< of a turn, from −π on

  /** A piece of a surface between two neighbouring hits, robot frame [m]. */
  struct Surface {
    mrpt::math::TPoint2Df from, to;
  };

  /** Takes over a scan; assigning again does not allocate.
   *  @param gap_m hits this near are of one surface */
  void assign(const PlanarScan& scan, double gap_m);

  /** Where it sees from, robot frame. */
  const mrpt::math::TPoint2Df& origin() const { return origin_; }
  /** How far it sees in a direction (index 0 to kDirections − 1), robot frame, squared [m²]; 0
   * where it does not look. */
  float squaredReach(int direction) const {
    return squaredReach_[static_cast<std::size_t>(direction)];
  }
  /** The same of all directions. */
  const std::array<float, kDirections>& squaredReach() const { return squaredReach_; }
  /** Whether it looks that way at all, however far. */
  bool looks(int direction) const { return squaredReach(direction) > 0.0f; }
  const std::vector<Surface>& surfaces() const { return surfaces_; }

 private:
  struct Beam {
    float angle_rad, range_m;
    bool hit;
    mrpt::math::TPoint2Df end;
  };

  void takeBeams(const PlanarScan& scan);
  void addWedge(const Beam& from, const Beam& to, float gap_m);

  mrpt::math::TPoint2Df origin_;
  float widestWedge_rad_ = 0.0f;
  std::vector<Beam> beams_;
  std::vector<Surface> surfaces_;
  std::array<float, kDirections> squaredReach_{};
};

}  // namespace bslnav
