#include "RecordedDrive.h"

#include <bslnav/evaluation/RunMemory.h>
#include <bslnav/evaluation/RunRawlog.h>
#include <bslnav/evaluation/RunRecorder.h>
#include <bslnav/evaluation/RunScene.h>
#include <bslnav/evaluation/ScenePicture.h>
#include <bslnav/evaluation/SimulationPictures.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/simulation/MvsimWorld.h>
#include <unistd.h>

#include <iostream>
#include <optional>
#include <vector>

#include "CommandLine.h"
#include "SummaryTable.h"

namespace bslnav {
namespace {

/** Leaves the files of the scene that are asked for; a picture that cannot be drawn is a warning.
 */
void saveScene(const RunScene& scene, const RecordingParameters& recording,
               const RunRecorder& recorder, std::vector<std::string>& pictures) {
  if (!recording.scene && !recording.scenePicture) return;
  const auto made = scene.make();
  if (recording.scene) bslnav::saveScene(*made, recorder.path("run.3Dscene"));
  if (!recording.scenePicture) return;
  const auto rendered = renderScene(*made, recording.pictureWidth_px, recording.pictureHeight_px);
  if (rendered.picture) {
    pictures.push_back(recorder.path("scene.png"));
    rendered.picture->save(pictures.back());
  } else {
    std::cerr << "bslnav: no scene.png: " << rendered.problem << '\n';
  }
}

}  // namespace

RunSummary driveRecorded(const SimulationSetup& setup, const Config& config,
                         const DriveOptions& options, const SimulationEngines& engines) {
  setup.check();
  engines.check(setup.simulation.engine);
  const auto map = setup.makeMap();
  RunRecorder recorder(options.out, config);
  if (setup.pictures.recordCandidates) recorder.recordCandidates();
  if (setup.recording.mvsimWorld)
    writeFile(recorder.path("world.mvsim.xml"), mvsimWorld(setup.simulationCase(options.seed)));
  std::optional<RunRawlog> rawlog;
  if (setup.recording.rawlog) rawlog.emplace(recorder.path("run.rawlog"));
  std::optional<RunMemory> memory;
  if (setup.recording.memory_s > 0.0)
    memory.emplace(recorder.directory(), setup.recording.memory_s);
  RunScene scene(setup, map);
  SimulationPictures pictures(setup, map);
  listenForInterrupts();
  const auto observe = [&](const SimulationMoment& moment) {
    recorder.write(moment.record, moment.truth.pose);
    if (rawlog) rawlog->write(moment.frame);
    if (setup.recording.scene || setup.recording.scenePicture) scene.observe(moment);
    pictures.observe(moment);
    if (memory)
      memory->observe(moment.record.time_s, {moment.truth.pose.x, moment.truth.pose.y}, [] {
        return std::vector<RunMemory::Program>{{"bslnav", ::getpid()}};
      });
    if (moment.record.index % 10 == 0) showProgress(progressLine(moment.record), options.quiet);
    return !interrupted();
  };
  RunSummary summary = runSimulation(setup, options.seed, observe, engines);
  showProgress("", options.quiet);
  recorder.finish(summary);
  auto paths = pictures.save(summary, recorder.directory());
  if (memory) paths.push_back(memory->save(setup.scenario.name + ": memory"));
  saveScene(scene, setup.recording, recorder, paths);
  if (!options.quiet)
    printSummary(std::cout, setup.scenario.name, summary, recorder.directory(), paths);
  return summary;
}

}  // namespace bslnav
