// Methods and engines in thousands of seeded encounters with people.
#include <bslnav/campaign/CampaignResults.h>
#include <bslnav/campaign/RowFile.h>
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <iostream>
#include <memory>

#include "CampaignOptions.h"
#include "ExperimentCommand.h"
#include "Ranks.h"
#include "RecordedDrive.h"
#include "SummaryTable.h"

namespace bslnav {
namespace {

/** One run again, with its records; config.ini is a scenario for bslnav. */
int replay(const CampaignOptions& options, const Campaign& campaign) {
  if (campaign.entrants.size() != 1)
    throw Error("--replay", "expected one --method, one --engine and one kind of --sensors");
  const Encounter encounter = makeEncounter(campaign.encounters, campaign.seed, *options.replay);
  SimulationSetup setup = setupOf(campaign.entrants.front(), encounter);
  Config config;
  setup.bind(config);
  return exitCodeOf(
      driveRecorded(setup, config, {encounter.seed, options.common.out, options.common.quiet}));
}

void report(const CampaignOptions& options, const std::vector<std::string>& leftOut) {
  const std::string& out = options.common.out;
  const auto results = resultsOf(readRows(out + "/results.csv"));
  const std::string tables = campaignTables(results);
  writeFile(out + "/tables.md", tables);
  writeFile(out + "/results.json", campaignJson(results));
  const auto pictures = saveCampaignFigures(results, out);
  if (options.common.quiet) return;
  std::cout << tables;
  for (const auto& entrant : leftOut) std::cout << "left out: " << entrant << '\n';
  std::cout << "\nfiles: " << out << "/{tables.md,results.csv,results.json,plan.ini}";
  for (const auto& picture : pictures) std::cout << ' ' << picture;
  std::cout << '\n';
}

/** This process's share of the runs. */
void run(const CampaignOptions& options, const Campaign& campaign, const Ranks& ranks) {
  listenForInterrupts();
  const std::string& out = options.common.out;
  if (ranks.rank() == 0) {
    makeDirectory(out);
    keepPlan(out, campaign.plan());
  }
  ranks.wait();
  RowFile rows(shardFile(out, ranks.rank(), ranks.size()));
  const bool quiet = options.common.quiet || ranks.rank() != 0;
  runShard(
      campaign, {ranks.rank(), ranks.size()}, rows.rows(), options.jobs,
      [&rows](const CampaignRow& row) { rows.append(row); }, watchWork("runs", quiet));
  showProgress("", quiet);
  ranks.wait();
  if (ranks.rank() == 0 && ranks.size() > 1) mergeShards(out, ranks.size());
}

int campaign(const CampaignOptions& options) {
  std::vector<std::string> leftOut;
  const Campaign all = makeCampaign(options, leftOut);
  if (options.replay) return replay(options, all);
  const Ranks ranks;
  try {
    run(options, all, ranks);
    if (ranks.rank() == 0) report(options, leftOut);
  } catch (const std::exception& problem) {
    ranks.fail(problem.what());
    throw;
  }
  return interrupted() ? 1 : 0;
}

}  // namespace

std::function<int()> addCampaignCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "campaign",
      "drives every method on every engine through the same seeded encounters with people who do "
      "not see the robot. A campaign that was stopped goes on by the same command; more "
      "--encounters extend it; mpirun shares it out");
  const auto options = std::make_shared<CampaignOptions>();
  options->addTo(*command);
  return [options] { return campaign(*options); };
}

}  // namespace bslnav
