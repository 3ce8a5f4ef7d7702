#pragma once

#include <bslnav/campaign/Encounter.h>

#include <string>
#include <vector>

#include "Dice.h"

namespace bslnav {

/** An opening in a wall along x, with a niche behind it. */
struct Opening {
  double x_m;  ///< of its middle
  double width_m = 1.2, depth_m = 2.2;
};

/** A corridor along x, from 1.5 m behind the robot's start. */
struct CorridorPlan {
  double length_m = 10.0;              ///< from the start to the end wall
  double right_m = 0.9, left_m = 0.9;  ///< from the robot's line to the walls, both positive
  std::vector<Opening> rightOpenings, leftOpenings;  ///< by rising x
};

/** Where a person and the robot are to meet: after how much of the ways of both. */
struct Meeting {
  double robot_m, person_m;
};

/** Puts places and people into an encounter. */
class EncounterBuilder {
 public:
  EncounterBuilder(const EncounterParameters& parameters, Dice& dice, Encounter& encounter)
      : parameters_(parameters), dice_(dice), encounter_(encounter) {}

  Dice& dice() { return dice_; }
  Encounter& encounter() { return encounter_; }

  void wall(std::vector<mrpt::math::TPoint2D> points_m);
  void box(const BoxParameters& box);
  void cylinder(const CylinderParameters& cylinder);
  void corridor(const CorridorPlan& plan);
  /** A person who comes this way, at a speed and a time that are drawn; now and then one stands for
   * a while, or turns back. */
  void person(std::vector<mrpt::math::TPoint2D> path_m, const Meeting& meeting);

 private:
  void startInTime(PedestrianParameters& person, const Meeting& meeting);
  void hesitate(PedestrianParameters& person, const Meeting& meeting);

  const EncounterParameters& parameters_;
  Dice& dice_;
  Encounter& encounter_;
};

/** @returns length of a polyline [m] */
double lengthOf(const std::vector<mrpt::math::TPoint2D>& points_m);

// What each family is made of.
void buildOneSided(EncounterBuilder& builder);
void buildTwoSided(EncounterBuilder& builder);
void buildCorner(EncounterBuilder& builder);
void buildDoors(EncounterBuilder& builder);
void buildAisles(EncounterBuilder& builder);
void buildBoxes(EncounterBuilder& builder);
void buildPillars(EncounterBuilder& builder);
void buildCrowd(EncounterBuilder& builder);

}  // namespace bslnav
