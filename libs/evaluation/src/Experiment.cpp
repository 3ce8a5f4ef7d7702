#include <bslnav/evaluation/Experiment.h>
#include <bslnav/evaluation/SimulationRun.h>

namespace bslnav {

std::vector<ExperimentResult> runAll(const std::vector<ExperimentCase>& cases,
                                     const SeedRange& seeds, int jobs, const WorkWatch& watch) {
  std::vector<ExperimentResult> results(cases.size() * seeds.count);
  const auto run = [&](std::size_t i) {
    const ExperimentCase& entry = cases[i % cases.size()];
    const std::uint64_t seed = seeds.first + i / cases.size();
    results[i] = {{entry.name, entry.method, seed}, runSimulation(varied(entry.setup, seed), seed)};
  };
  results.resize(doInParallel(results.size(), jobs, run, watch));
  return results;
}

}  // namespace bslnav
