// Evaluates a recorded log offline: what would the planner have seen and commanded?
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/GuardAudit.h>
#include <bslnav/evaluation/RawlogPictures.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <cstdio>
#include <iostream>

#include "CommandLine.h"
#include "HardwareSetup.h"
#include "SummaryTable.h"

namespace {

int evaluate(bslnav::CommonOptions options, const std::string& rawlog, const std::string& map) {
  using namespace bslnav;
  RawlogSetup setup;
  Config config;
  setup.bind(config);
  HardwareSetup hardware;  // which the configuration of a recorded run has, too
  hardware.bind(config);
  if (options.configs.empty()) options.configs = {dataDirectory() + "/config/rawlog.ini"};
  options.load(config);
  if (!rawlog.empty()) setup.rawlog.file = rawlog;
  if (!map.empty()) setup.rawlog.map = map;
  if (options.printConfig) {
    config.print(std::cout);
    return 0;
  }
  setup.check();
  showProgress("reading and localising " + setup.rawlog.file, options.quiet);
  const LocalizedLog log = localizeLog(setup, options.seed);

  RunRecorder recorder(options.out, config);
  if (setup.pictures.recordCandidates) recorder.recordCandidates();
  RawlogPictures pictures(setup, log);
  GuardAudit audit(setup.navigation, log.map);
  listenForInterrupts();
  RunSummary summary = evaluateLog(setup, log, options.seed, [&](const RawlogMoment& moment) {
    recorder.write(moment.record, moment.record.mapFromRobot);
    pictures.observe(moment);
    audit.observe(moment);
    if (moment.record.index % 50 == 0)
      showProgress(std::to_string(static_cast<int>(100.0 * moment.progress)) + " %", options.quiet);
    return !interrupted();
  });
  showProgress("", options.quiet);
  if (setup.navigation.guard.enabled) summary.rawlog->guard = audit.findings();
  pictures.add(audit);
  recorder.finish(summary);
  const auto paths = pictures.save(summary, recorder.directory());
  if (!options.quiet)
    printSummary(std::cout, setup.rawlog.file, summary, recorder.directory(), paths);
  return exitCodeOf(summary);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Evaluates a recorded log offline: what would the planner have seen and commanded?",
               "bslnav-rawlog");
  app.footer(
      "Examples:\n  bslnav-rawlog config/rawlog.ini --rawlog near-miss.rawlog --method 2 --out "
      "out/near-miss\n"
      "  bslnav-rawlog config/scenarios/s1.ini --rawlog out/s1/run.rawlog --method 2   # a run of "
      "bslnav with [recording] rawlog, again");
  bslnav::CommonOptions options;
  std::string rawlog, map;
  options.addTo(app, "out");
  app.add_option("--rawlog", rawlog, "the log, MRPT's .rawlog in either format");
  app.add_option("--map", map, "map file (.gridmap, .simplemap, .yaml, .png), 'log' or 'none'");
  return bslnav::runApp(app, argc, argv, [&] { return evaluate(options, rawlog, map); });
}
