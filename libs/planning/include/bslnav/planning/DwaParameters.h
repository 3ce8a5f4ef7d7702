#pragma once

#include <bslnav/planning/CostTerms.h>
#include <bslnav/planning/OscillationGuard.h>

namespace bslnav {

/** Candidates and costs of the dynamic window approach (paper III-B, table I). */
struct DwaParameters {
  double horizon_s = 4.0;  ///< T_pre
  double step_s = 0.1;
  double window_s = 1.0;  ///< within one control period a robot that stands could only creep, and
                          ///< creeping never pays for crossing a graded cost
  int speedSamples = 20, yawRateSamples = 40;
  int lateralSamples = 1;  ///< counts for a robot that can move sideways
  bool allowUnknown = false;
  CostWeights weights;
  OscillationParameters oscillation;

  void describe(ConfigSection& section);
};

}  // namespace bslnav
