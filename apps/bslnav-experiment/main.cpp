// Compares methods over many seeds of one scenario.
#include <bslnav/config/Error.h>
#include <bslnav/config/Version.h>
#include <bslnav/evaluation/RunRecorder.h>
#include <bslnav/evaluation/SeedTable.h>
#include <bslnav/evaluation/SimulationRun.h>

#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>

#include "CommandLine.h"

namespace {

using namespace bslnav;

/** The setup of one method, loaded afresh: files, then the method's overlay, then the overrides. */
void load(SimulationSetup& setup, Config& config, CommonOptions options, int method) {
  setup.bind(config);
  options.method = method;
  options.load(config);
}

int compare(const CommonOptions& options, const std::vector<int>& methods, int runs) {
  if (options.configs.empty())
    throw Error("CONFIG",
                "no configuration; expected bslnav-experiment seeds CONFIG.ini, see --help");
  if (std::set<int>(methods.begin(), methods.end()).size() != methods.size())
    throw Error("--methods", "expected each method once");
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) throw Error(options.out, "cannot be made: " + problem.message(), Error::Kind::Run);
  for (const int method : methods) {
    SimulationSetup setup;
    Config config;
    load(setup, config, options, method);
    std::ostringstream ini;
    config.print(ini);
    writeFile(options.out + "/config-method" + std::to_string(method) + ".ini", ini.str());
  }

  SeedTable table;
  listenForInterrupts();
  for (int i = 0; i < runs && !interrupted(); ++i)
    for (const int method : methods) {
      SimulationSetup setup;
      Config config;
      load(setup, config, options, method);
      table.scenario = setup.scenario.name;
      const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
      showProgress("seed " + std::to_string(seed) + ", method " + std::to_string(method),
                   options.quiet);
      table.runs.push_back(runSimulation(varied(setup, seed), seed));
    }
  showProgress("", options.quiet);

  writeFile(options.out + "/results.csv", table.csv());
  writeFile(options.out + "/table.md", table.markdown());
  if (!options.quiet)
    std::cout << table.markdown() << "\nfiles: " << options.out << "/{table.md,results.csv}\n";
  return interrupted() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares methods over many seeds of a scenario.", "bslnav-experiment");
  app.footer(
      "Example:\n  bslnav-experiment seeds config/scenarios/s1.ini --methods 1 2 --runs 17 --out "
      "out/s1-seeds");
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  CLI::App* seeds = app.add_subcommand("seeds",
                                       "runs each method over the same seeds: trigger lines and "
                                       "speeds vary as [scenario] says, and so does all noise");
  CommonOptions options;
  options.addTo(*seeds, "out");
  std::vector<int> methods{1, 2};
  int runs = 17;
  seeds->add_option("--methods", methods, "methods to compare")->capture_default_str();
  seeds->add_option("--runs", runs, "seeds a method, from --seed on")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  return runApp(app, argc, argv, [&] { return compare(options, methods, runs); });
}
