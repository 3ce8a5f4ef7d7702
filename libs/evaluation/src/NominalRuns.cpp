#include <bslnav/evaluation/NominalRuns.h>
#include <bslnav/evaluation/SimulationRun.h>

namespace bslnav {

std::vector<NominalRun> runNominal(const std::vector<ExperimentCase>& cases, std::uint64_t seed,
                                   int jobs, const WorkWatch& watch) {
  std::vector<NominalRun> runs(cases.size());
  const auto run = [&](std::size_t i) {
    runs[i].entry = cases[i];
    const SimulationSetup& setup = runs[i].entry.setup;
    runs[i].summary = runSimulation(setup, seed, [&](const SimulationMoment& moment) {
      runs[i].trace.observe(moment, setup.pictures.snapshots_s);
      return true;
    });
  };
  runs.resize(doInParallel(runs.size(), jobs, run, watch));
  return runs;
}

}  // namespace bslnav
