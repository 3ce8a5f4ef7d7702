#pragma once

#include <bslnav/evaluation/ParallelWork.h>
#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/evaluation/SimulationSetup.h>

#include <cstdint>
#include <string>
#include <vector>

namespace bslnav {

/** A case as one method drives it: what all its runs share. */
struct ExperimentCase {
  std::string name;  ///< of the case, for example "s1"
  int method = 0;
  SimulationSetup setup;
  std::string configuration;  ///< the effective one, as an INI file
};

/** Which run of an experiment this is. */
struct ExperimentRun {
  std::string caseName;
  int method = 0;
  std::uint64_t seed = 0;
};

struct ExperimentResult {
  ExperimentRun run;
  RunSummary summary;
};

/** Consecutive seeds. */
struct SeedRange {
  std::uint64_t first = 1;
  std::size_t count = 100;
};

/** Runs every case over the same seeds, varied as its scenario says, on several threads.
 *
 * Results are in the order in which runs begin: seed by seed, the cases of a seed as given. When it
 * is stopped, the runs that were begun are finished; so each case has the same seeds, but for the
 * last one. They do not depend on the number of jobs.
 *  @param jobs threads; 0 for one a core
 *  @throws Error when a setup cannot be run */
std::vector<ExperimentResult> runAll(const std::vector<ExperimentCase>& cases,
                                     const SeedRange& seeds, int jobs, const WorkWatch& watch = {});

}  // namespace bslnav
