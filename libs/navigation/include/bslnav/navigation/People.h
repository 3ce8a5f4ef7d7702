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

  /** @param scans new in this cycle, in the robot frame of `mapFromRobot`
   *  @param stamp_s when the oldest of them was taken
   *  @param personSpeed_mps how fast people walk at most */
  void update(const std::vector<PlanarScan>& scans, double stamp_s,
              const mrpt::math::TPose2D& mapFromRobot, double personSpeed_mps);

  /** The places from which they come, map frame: first the hidden ones, then those seen. */
  const Frontier& frontier() const { return frontier_; }
  /** Those who are seen walking. */
  const Movers& movers() const { return seen_.movers(); }
  /** When the frontier was seen. */
  double stamp_s() const { return hidden_.stamp_s(); }

 private:
  HiddenPeople hidden_;
  SeenPeople seen_;
  std::vector<const PlanarScan*> views_;
  Frontier frontier_;
};

}  // namespace bslnav
