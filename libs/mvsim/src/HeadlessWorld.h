#pragma once

#include <bslnav/simulation/SimulationEngine.h>
#include <mvsim/World.h>

#include <vector>

namespace bslnav {

/** A case in a world of MVSim that runs in this process, without window, network or clock. */
class HeadlessWorld {
 public:
  /** @throws Error as mvsimWorld() does, or (Run) with what MVSim says of its own accord */
  explicit HeadlessWorld(const SimulationCase& simulated);

  /** Simulates `dt_s`. @param command robot frame */
  void advance(const mrpt::math::TTwist2D& command, double dt_s);
  /** Puts the people, by name, at points of the map. */
  void placePeople(const std::vector<mrpt::math::TPoint2D>& positions);

  /** Exact distances [m] from a laser, in the order of the lasers' names, one a beam,
   * counterclockwise; infinity where nothing is. */
  const std::vector<float>& distances(std::size_t laser);

  /** In the map. */
  mrpt::math::TPose2D pose() const;
  /** In the robot frame. */
  mrpt::math::TTwist2D twist() const { return vehicle().getVelocityLocal(); }
  /** What the turning of the wheels says, in the robot frame. */
  mrpt::math::TTwist2D wheelTwist() const { return vehicle().getVelocityLocalOdoEstimate(); }

 private:
  mvsim::VehicleBase& vehicle() const { return *world_.getListOfVehicles().begin()->second; }

  mvsim::World world_;
  std::vector<mvsim::Block::Ptr> people_;
  std::vector<double> scansTaken_;  // of each laser
  mrpt::obs::CObservation2DRangeScan::Ptr newest_;
  std::vector<float> distances_m_;
};

}  // namespace bslnav
