// Compares methods over many runs.
#include <bslnav/config/Version.h>

#include "ExperimentCommand.h"

int main(int argc, char** argv) {
  CLI::App app("Compares methods over many runs.", "bslnav-experiment");
  app.footer(
      "Examples:\n"
      "  bslnav-experiment paper --out out/paper\n"
      "  bslnav-experiment seeds config/scenarios/s1.ini --methods 1 2 --runs 17 --out "
      "out/s1-seeds\n"
      "  bslnav-experiment navigators --out out/navigators\n"
      "  bslnav-experiment campaign --method 4 --method 5 --encounters 80 --out out/campaign");
  app.set_version_flag("--version", bslnav::version());
  app.require_subcommand(1);
  const auto paper = bslnav::addPaperCommand(app), seeds = bslnav::addSeedsCommand(app);
  const auto navigators = bslnav::addNavigatorsCommand(app);
  const auto campaign = bslnav::addCampaignCommand(app);
  return bslnav::runApp(app, argc, argv, [&] {
    if (app.got_subcommand("paper")) return paper();
    if (app.got_subcommand("seeds")) return seeds();
    return app.got_subcommand("navigators") ? navigators() : campaign();
  });
}
