#pragma once

#include <bslnav/evaluation/Experiment.h>
#include <bslnav/evaluation/RunTrace.h>

#include <vector>

namespace bslnav {

/** A run of a case as its scenario is written, not varied, with what its pictures show. */
struct NominalRun {
  ExperimentCase entry;
  RunSummary summary;
  RunTrace trace;
};

/** Runs every case once as written, on several threads.
 *  @param jobs threads; 0 for one a core
 *  @returns in the order of the cases; when it is stopped, of the first ones
 *  @throws Error when a setup cannot be run */
std::vector<NominalRun> runNominal(const std::vector<ExperimentCase>& cases, std::uint64_t seed,
                                   int jobs, const WorkWatch& watch = {});

}  // namespace bslnav
