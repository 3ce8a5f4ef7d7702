#pragma once

#include <bslnav/blindspot/HiddenPeople.h>
#include <bslnav/blindspot/SeenPeople.h>

#include <memory>
#include <vector>

namespace bslnav {

/** Everybody who may step in the robot's way: who is seen, and who may be hidden. */
class People {
 public:
  People(const HiddenPeopleParameters& hidden, const SeenPeopleParameters& seen,
         double bodyRadius_m, const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
         const StaticParameters& mapThresholds)
      : hidden_(hidden, bodyRadius_m, map, mapThresholds), seen_(seen) {}

  /** What is new in a cycle. */
  struct Views {
    const std::vector<PlanarScan>& lasers;
    const std::vector<PlanarScan>& cameras;    ///< how far they see people
    const std::vector<PlanarScan>& obstacles;  ///< of the same images: how high things are
  };

  /** @param views in the robot frame of `mapFromRobot`; visible to one of them is visible
   *  @param stamp_s when the oldest of them was taken
   *  @param personSpeed_mps how fast people walk at most */
  void update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
              double personSpeed_mps);

  /** The places from which they come, map frame: first the hidden ones, then those seen. */
  const Frontier& frontier() const { return frontier_; }
  /** The nearest point of each who is seen, map frame. */
  const std::vector<mrpt::math::TPoint2D>& seen() const { return seen_.people(); }
  /** Those who are seen walking. */
  const Movers& movers() const { return seen_.movers(); }
  /** Whether whoever comes from behind would be seen. */
  bool looksBehind() const { return hidden_.looksBehind(); }
  /** When the frontier was seen. */
  double stamp_s() const { return hidden_.stamp_s(); }

 private:
  HiddenPeople hidden_;
  SeenPeople seen_;
  SeenPeople::Views views_;
  Frontier frontier_;
};

}  // namespace bslnav
