#pragma once

#include <bslnav/evaluation/RawlogSetup.h>
#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/navigation/NavigationCycle.h>

#include <functional>

namespace bslnav {

/** The velocity that the planner wanted to reach in a cycle; its command is as near to it as one
 * control period allows. */
mrpt::math::TTwist2D chosenVelocity(const CycleRecord& record);

/** What an observer of an offline evaluation sees after every control cycle. */
struct RawlogMoment {
  const CycleRecord& record;
  const NavigationCycle& cycle;
  double progress;  ///< 0 to 1
};
/** Called after every cycle; returning false interrupts the evaluation. */
using RawlogObserver = std::function<bool(const RawlogMoment&)>;

/** A log, localised: what an evaluation needs to know before it starts. */
struct LocalizedLog {
  RecordedPath path;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map;  ///< null for none
  RawlogFindings findings;
};

/** Reads the whole log once: where the robot was, and the map.
 *  @throws Error when the log or the map cannot be read, or the map is to come from a log without
 *  scans */
LocalizedLog localizeLog(const RawlogSetup& setup, std::uint64_t seed);

/** Runs the control cycle over the log: what would the planner have seen and commanded?
 *
 * The robot does as recorded; the goal is taken from the recorded future, or where the setup
 * repeats a run, from its scenario: then the commands are those of the run, cycle by cycle. */
RunSummary evaluateLog(const RawlogSetup& setup, const LocalizedLog& log, std::uint64_t seed,
                       const RawlogObserver& observer = {});

}  // namespace bslnav
