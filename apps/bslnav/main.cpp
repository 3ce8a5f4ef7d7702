// Drives a robot to its goal: in the simulator now; what the configuration describes is what moves.
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RunRawlog.h>
#include <bslnav/evaluation/RunRecorder.h>
#include <bslnav/evaluation/RunScene.h>
#include <bslnav/evaluation/ScenePicture.h>
#include <bslnav/evaluation/SimulationPictures.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/simulation/MvsimWorld.h>
#ifdef BSLNAV_WITH_MVSIM
#include <bslnav/mvsim/MvsimSimulator.h>
#endif

#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "CommandLine.h"
#include "SummaryTable.h"

namespace {

/** Leaves the files of the scene that are asked for; a picture that cannot be drawn is a warning.
 */
void saveScene(const bslnav::RunScene& scene, const bslnav::RecordingParameters& recording,
               const bslnav::RunRecorder& recorder, std::vector<std::string>& pictures) {
  if (!recording.scene && !recording.scenePicture) return;
  const auto made = scene.make();
  if (recording.scene) bslnav::saveScene(*made, recorder.path("run.3Dscene"));
  if (!recording.scenePicture) return;
  const auto rendered =
      bslnav::renderScene(*made, recording.pictureWidth_px, recording.pictureHeight_px);
  if (rendered.picture) {
    pictures.push_back(recorder.path("scene.png"));
    rendered.picture->save(pictures.back());
  } else {
    std::cerr << "bslnav: no scene.png: " << rendered.problem << '\n';
  }
}

/** The engines that this build has. */
bslnav::SimulationEngines availableEngines() {
  bslnav::SimulationEngines engines;
#ifdef BSLNAV_WITH_MVSIM
  engines.add(bslnav::EngineKind::Mvsim, [](const bslnav::SimulationCase& simulated) {
    return std::make_unique<bslnav::MvsimSimulator>(simulated);
  });
#endif
  return engines;
}

int drive(const bslnav::CommonOptions& options) {
  using namespace bslnav;
  SimulationSetup setup;
  Config config;
  setup.bind(config);
  options.load(config);
  if (options.printConfig) {
    config.print(std::cout);
    return 0;
  }
  if (options.configs.empty())
    throw Error("CONFIG", "no configuration; expected bslnav CONFIG.ini, see --help");
  setup.check();
  const SimulationEngines engines = availableEngines();
  engines.check(setup.simulation.engine);
  const auto map = setup.makeMap();

  RunRecorder recorder(options.out, config);
  if (setup.pictures.recordCandidates) recorder.recordCandidates();
  if (setup.recording.mvsimWorld)
    writeFile(recorder.path("world.mvsim.xml"), mvsimWorld(setup.simulationCase(options.seed)));
  std::optional<RunRawlog> rawlog;
  if (setup.recording.rawlog) rawlog.emplace(recorder.path("run.rawlog"));
  RunScene scene(setup, map);
  SimulationPictures pictures(setup, map);
  listenForInterrupts();
  const RunSummary summary = runSimulation(
      setup, options.seed,
      [&](const SimulationMoment& moment) {
        recorder.write(moment.record, moment.truth.pose);
        if (rawlog) rawlog->write(moment.frame);
        if (setup.recording.scene || setup.recording.scenePicture) scene.observe(moment);
        pictures.observe(moment);
        if (moment.record.index % 10 == 0) showProgress(progressLine(moment.record), options.quiet);
        return !interrupted();
      },
      engines);
  showProgress("", options.quiet);
  recorder.finish(summary);
  auto paths = pictures.save(summary, recorder.directory());
  saveScene(scene, setup.recording, recorder, paths);
  if (!options.quiet)
    printSummary(std::cout, setup.scenario.name, summary, recorder.directory(), paths);
  return exitCodeOf(summary);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Drives a robot past blind spots to its goal.", "bslnav");
  app.footer("Example:\n  bslnav config/scenarios/s1.ini --method 2 --out out/s1-method2");
  bslnav::CommonOptions options;
  options.addTo(app, "out");
  return bslnav::runApp(app, argc, argv, [&] { return drive(options); });
}
