#pragma once

#include <bslnav/evaluation/RunSummary.h>

#include <string>
#include <vector>

namespace bslnav {

/** The columns of a run in results.csv after those that say which run it is. */
inline constexpr const char* kRunColumns =
    "outcome,contact,at_fault,impact_speed_mps,min_clearance_m,time_to_goal_s,path_length_m,"
    "time_stopped_s,blind_spots_mean";
/** The cells of these columns; empty where a run has no value. */
std::string runCells(const RunSummary& run);

/** A CSV field that may hold anything. */
std::string csvField(const std::string& field);

/** "12.0 +/- 2.3", or "-" for no values. */
std::string meanCell(const std::vector<double>& values);

}  // namespace bslnav
