#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <limits>
#include <vector>

namespace bslnav {

/** The truth at one moment; map frame unless said otherwise. */
struct SimulationState {
  enum class Contact { Nothing, Person, World };
  struct Person {
    mrpt::math::TPoint2D position;
    double radius_m = 0.0;
    bool started = false;  ///< stays true at the end of the walk
    double speed_mps = 0.0;
  };

  double time_s = 0.0;
  mrpt::math::TPose2D pose;
  mrpt::math::TTwist2D twist;    ///< robot frame
  mrpt::math::TPose2D odometry;  ///< starts at the true pose
  std::vector<Person> people;    ///< by name of the pedestrian, alphabetically
  double clearanceToPeople_m = std::numeric_limits<double>::infinity();
  double clearanceToWorld_m = std::numeric_limits<double>::infinity();
  double minClearanceToPeople_m = std::numeric_limits<double>::infinity();  ///< of all substeps
  Contact contact = Contact::Nothing;  ///< the first one of the run
  double contactTime_s = 0.0;          ///< of that contact
  double speedAtContact_mps = 0.0;     ///< the robot's, never negative
};

}  // namespace bslnav
