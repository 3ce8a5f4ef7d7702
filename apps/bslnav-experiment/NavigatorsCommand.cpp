// Engines side by side: the velocity window, MRPT's PTGs with our evaluator, and MRPT as it comes.
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/NavigatorTable.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "Engines.h"
#include "ExperimentCommand.h"

namespace bslnav {
namespace {

/** The cases of a scenario file: each engine with each method. */
void addCases(const std::string& file, const ExperimentOptions& options,
              std::vector<ExperimentCase>& cases, std::vector<std::string>& names) {
  for (const Engine& engine : engines())
    for (const int method : options.methods) {
      CommonOptions common = options.common;
      common.configs = engine.files();
      common.configs.insert(common.configs.begin(), file);
      common.overrides.insert(common.overrides.begin(), engine.overrides.begin(),
                              engine.overrides.end());
      cases.push_back(loadCase(std::filesystem::path(file).stem().string(), common, method));
      names.push_back(engine.title);
    }
}

int compare(const ExperimentOptions& options) {
  options.check();
  auto files = options.common.configs;
  if (files.empty())
    for (const char* name : {"s1", "s2"})
      files.push_back(dataDirectory() + "/config/scenarios/" + name + ".ini");
  std::vector<ExperimentCase> cases;
  std::vector<std::string> names;
  for (const auto& file : files) addCases(file, options, cases, names);
  listenForInterrupts();
  makeDirectory(options.common.out);

  NavigatorTable table;
  std::size_t i = 0;  // results come seed by seed, the cases of a seed in order
  for (const ExperimentResult& result :
       runAll(cases, options.seeds(), options.jobs, watchWork("runs", options.common.quiet))) {
    const std::size_t which = i++ % cases.size();
    table.rows.push_back({cases[which].setup.scenario.name, names[which], result.summary});
  }
  showProgress("", options.common.quiet);
  writeFile(options.common.out + "/results.csv", table.csv());
  writeFile(options.common.out + "/table.md", table.markdown());
  if (!options.common.quiet)
    std::cout << table.markdown() << "\nfiles: " << options.common.out
              << "/{table.md,results.csv}\n";
  return interrupted() ? 1 : 0;
}

}  // namespace

std::function<int()> addNavigatorsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "navigators",
      "runs the velocity window, MRPT's PTGs with our cost function and MRPT as it comes over the "
      "same seeds of each CONFIG; without one of S1 and S2");
  const auto options = std::make_shared<ExperimentOptions>();
  options->addTo(*command, {1, 4}, 100);
  command->remove_option(command->get_option("--navigator"));  // it compares them all
  return [options] { return compare(*options); };
}

}  // namespace bslnav
