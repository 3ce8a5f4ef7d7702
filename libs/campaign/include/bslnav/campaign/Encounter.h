#pragma once

#include <bslnav/campaign/Yardstick.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/simulation/WorldParameters.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** The kinds of places in which robot and people meet. */
enum class Family : std::uint8_t {
  OneSided,  ///< a corridor with an opening in one wall
  TwoSided,  ///< a crossing
  Corner,    ///< a corridor that turns by 90 degrees
  Doors,     ///< a row of doors on both sides
  Aisles,    ///< between shelves with gaps
  Boxes,     ///< a corridor with boxes parked at a wall; the map does not show them
  Pillars,   ///< a hall with two rows of pillars
  Crowd      ///< an open hall that many people cross
};
inline constexpr int kFamilies = 8;
/** The word for a family in tables and on the command line. */
const char* nameOf(Family family);

/** Who is met, and how. */
struct EncounterParameters {
  double slowest_mps = 0.6, fastest_mps = 4.0 / 3.6;  ///< people's speeds, uniform in between
  double timingSpread_s = 1.5;  ///< robot and person reach the same place within this of each other
  double hesitate_share = 0.35;  ///< of people who stand on the way for a while, or turn back
  bool yield = false;            ///< whether people wait for a robot that is in their way
  double patience_s = 2.0;       ///< who has waited so long walks round the robot; 0: waits on

  void describe(ConfigSection& section);
  /** @throws Error naming section and key */
  void check() const;
};

/** A place, a way through it for the robot, and the people who come out; map frame.
 *
 * The robot starts at the origin, heading along x. */
struct Encounter {
  Family family = Family::OneSided;
  std::uint64_t seed = 1;  ///< of all noise in this encounter's runs
  WorldParameters world;
  mrpt::math::TPose2D start;
  std::vector<mrpt::math::TPose2D> goals;
  double timeLimit_s = 90.0;
  std::optional<CornerPass> pass;  ///< its plain geometry, of a one-sided opening; unmirrored
};

/** An encounter of a campaign: families take turns, everything else is drawn from the campaign's
 * seed and the number, and from nothing else, so that every method meets the same.
 *  @param number from 0 */
Encounter makeEncounter(const EncounterParameters& parameters, std::uint64_t campaignSeed,
                        long number);

}  // namespace bslnav
