// Each method over the same seeds of one scenario.
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RunRecorder.h>
#include <bslnav/evaluation/SeedTable.h>

#include <iostream>
#include <memory>

#include "ExperimentCommand.h"

namespace bslnav {
namespace {

int compare(const ExperimentOptions& options) {
  const CommonOptions& common = options.common;
  if (common.configs.empty())
    throw Error("CONFIG",
                "no configuration; expected bslnav-experiment seeds CONFIG.ini, see --help");
  options.check();
  std::vector<ExperimentCase> cases;
  for (const int method : options.methods) cases.push_back(loadCase("", common, method));
  listenForInterrupts();
  makeDirectory(common.out);
  for (const ExperimentCase& entry : cases)
    writeFile(common.out + "/config-method" + std::to_string(entry.method) + ".ini",
              entry.configuration);

  SeedTable table{cases.front().setup.scenario.name, {}};
  for (ExperimentResult& result :
       runAll(cases, options.seeds(), options.jobs, watchWork("runs", common.quiet)))
    table.runs.push_back(std::move(result.summary));
  showProgress("", common.quiet);

  writeFile(common.out + "/results.csv", table.csv());
  writeFile(common.out + "/table.md", table.markdown());
  if (!common.quiet)
    std::cout << table.markdown() << "\nfiles: " << common.out << "/{table.md,results.csv}\n";
  return interrupted() ? 1 : 0;
}

}  // namespace

std::function<int()> addSeedsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("seeds",
                                         "runs each method over the same seeds: trigger lines and "
                                         "speeds vary as [scenario] says, and so does all noise");
  const auto options = std::make_shared<ExperimentOptions>();
  options->addTo(*command, {1, 2}, 17);
  return [options] { return compare(*options); };
}

}  // namespace bslnav
