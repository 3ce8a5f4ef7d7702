#pragma once

#include <bslnav/evaluation/Experiment.h>

#include <string>
#include <vector>

#include "CommandLine.h"

namespace bslnav {

/** The options that the subcommands share. */
struct ExperimentOptions {
  CommonOptions common;
  std::vector<int> methods;
  int runs = 0, jobs = 0;

  /** @param defaultMethods,defaultRuns when the command line names none */
  void addTo(CLI::App& command, std::vector<int> defaultMethods, int defaultRuns);
  /** @throws Error when a method is named twice */
  void check() const;

  SeedRange seeds() const { return {common.seed, static_cast<std::size_t>(runs)}; }
};

/** Loads a case by one method: the files, then the method's overlay, then the overrides. */
ExperimentCase loadCase(const std::string& name, const CommonOptions& options, int method);

/** Shows how many runs are done and how long the rest will take; stops at an interrupt. */
WorkWatch watchWork(const std::string& what, bool quiet);

/** Makes a directory. @throws Error (Run) when it cannot */
void makeDirectory(const std::string& directory);

/** Adds the subcommand `seeds`. @returns what runs it */
std::function<int()> addSeedsCommand(CLI::App& app);
/** Adds the subcommand `paper`. @returns what runs it */
std::function<int()> addPaperCommand(CLI::App& app);
/** Adds the subcommand `navigators`. @returns what runs it */
std::function<int()> addNavigatorsCommand(CLI::App& app);
/** Adds the subcommand `campaign`. @returns what runs it */
std::function<int()> addCampaignCommand(CLI::App& app);

}  // namespace bslnav
