#pragma once

#include <bslnav/evaluation/RunSummary.h>

#include <vector>

namespace bslnav {

/** What the runs of one method add up to. */
struct RunTally {
  int runs = 0, goals = 0, contacts = 0, atFault = 0;
  int other = 0;                    ///< neither goal nor contact
  std::vector<double> times_s;      ///< to the goal, of those that reached it
  std::vector<double> clearance_m;  ///< to the nearest person, of runs with people; never negative

  void add(const RunSummary& run);
};

RunTally tallyOf(const std::vector<RunSummary>& runs);

/** Mean of some values and half the width of its 95 % interval (normal approximation; 0 for fewer
 * than two values). */
struct MeanInterval {
  double mean = 0.0, half = 0.0;
};
MeanInterval meanInterval(const std::vector<double>& values);

/** The middle value, or the mean of the two in the middle; 0 for none. */
double median(std::vector<double> values);

}  // namespace bslnav
