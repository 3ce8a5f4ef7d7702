// The paper's tables and figures with one command.
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/PaperFigures.h>
#include <bslnav/evaluation/PaperTables.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "ExperimentCommand.h"

namespace bslnav {
namespace {

/** The file of a case. @throws Error when there is no such case */
std::string caseFile(const std::string& name) {
  std::string file = dataDirectory() + "/config/scenarios/" + name + ".ini";
  const auto isPlain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (!std::all_of(name.begin(), name.end(), isPlain) || !std::filesystem::exists(file))
    throw Error("--cases " + name, "no such case; expected a name with a file " + file);
  return file;
}

std::vector<ExperimentCase> loadCases(const ExperimentOptions& options,
                                      const std::vector<std::string>& names) {
  options.check();
  if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
    throw Error("--cases", "expected each case once");
  std::vector<ExperimentCase> cases;
  for (const std::string& name : names) {
    CommonOptions ofCase = options.common;
    ofCase.configs.insert(ofCase.configs.begin(), caseFile(name));
    for (const int method : options.methods) cases.push_back(loadCase(name, ofCase, method));
  }
  return cases;
}

/** Draws both figures of each case that has a nominal run. */
void saveFigures(const std::vector<NominalRun>& nominal, const std::string& directory) {
  for (auto first = nominal.begin(); first != nominal.end();) {
    const std::string& name = first->entry.name;
    const auto last = std::find_if(
        first, nominal.end(), [&name](const NominalRun& run) { return run.entry.name != name; });
    const std::vector<NominalRun> runs(first, last);
    caseFigure(runs).save(directory + "/figure-" + name + ".png");
    speedFigure(runs).save(directory + "/speed-" + name + ".png");
    first = last;
  }
}

int reproduce(const ExperimentOptions& options, const std::vector<std::string>& names) {
  const CommonOptions& common = options.common;
  const std::vector<ExperimentCase> cases = loadCases(options, names);
  listenForInterrupts();
  makeDirectory(common.out);
  for (const ExperimentCase& entry : cases)
    writeFile(
        common.out + "/config-" + entry.name + "-method" + std::to_string(entry.method) + ".ini",
        entry.configuration);

  const auto nominal =
      runNominal(cases, common.seed, options.jobs, watchWork("nominal runs", common.quiet));
  const auto seeds = runAll(cases, options.seeds(), options.jobs, watchWork("seeds", common.quiet));
  showProgress("", common.quiet);

  const auto results = paperResults(cases, nominal, seeds);
  const std::string tables = paperTables(results, options.seeds());
  writeFile(common.out + "/results.csv", resultsCsv(results));
  writeFile(common.out + "/results.json", resultsJson(results));
  writeFile(common.out + "/tables.md", tables);
  saveFigures(nominal, common.out);
  if (!common.quiet)
    std::cout << tables << "\nfiles: " << common.out
              << "/{tables.md,results.csv,results.json,figure-CASE.png,speed-CASE.png,"
                 "config-CASE-methodN.ini}\n";
  return interrupted() ? 1 : 0;
}

}  // namespace

std::function<int()> addPaperCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "paper",
      "reproduces the paper's tables and figures: every case by every method, once as written and "
      "over many seeds. CONFIG files are read after the case's own");
  const auto options = std::make_shared<ExperimentOptions>();
  options->addTo(*command, {1, 2, 3, 4}, 100);
  const auto cases =
      std::make_shared<std::vector<std::string>>(std::vector<std::string>{"s1", "s2", "e1", "e2"});
  command->add_option("--cases", *cases, "cases: names of files in config/scenarios")
      ->capture_default_str();
  return [options, cases] { return reproduce(*options, *cases); };
}

}  // namespace bslnav
