#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RawlogRun.h>
#include <bslnav/navigation/Localization.h>
#include <bslnav/navigation/RawlogReader.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/system/CTicTac.h>

#include <cmath>

namespace bslnav {
namespace {

/** A scan for MRPT's map, which would take NaN for a range: a beam of length 0 says nothing. */
mrpt::obs::CObservation2DRangeScan usableScan(const mrpt::obs::CObservation2DRangeScan& scan) {
  auto usable = scan;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    if (std::isfinite(scan.getScanRange(i)) && scan.getScanRange(i) > 0.0f) continue;
    usable.setScanRange(i, 0.0f);
    usable.setScanRangeValidity(i, false);
  }
  return usable;
}

RawlogReader readerOf(const RawlogSetup& setup) {
  return RawlogReader(
      setup.rawlog.file, setup.rawlog.gap_s,
      setup.takesRecordedPoses() ? RawlogFraming::RecordedPoses : RawlogFraming::Measurements);
}

std::unique_ptr<Localization> localizationOf(
    const RawlogSetup& setup, const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
    std::uint64_t seed) {
  if (setup.takesRecordedPoses()) return std::make_unique<RecordedLocalization>();
  if (setup.localization.source == PoseSource::Odometry)
    return std::make_unique<OdometryLocalization>(setup.rawlog.initialPose);
  return std::make_unique<ParticleFilterLocalization>(
      setup.particleFilter, map, setup.rawlog.initialPose, static_cast<std::uint32_t>(seed));
}

/** The map that the log's own scans give at the localised poses. */
std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> mapFromLog(const RawlogSetup& setup,
                                                                  const RecordedPath& path) {
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(-1.0, 1.0, -1.0, 1.0,
                                                               setup.rawlog.mapResolution_m);
  RawlogReader reader = readerOf(setup);
  for (SensorFrame frame; reader.next(frame);) {
    const mrpt::poses::CPose3D pose(path.poseAt(frame.time_s));
    for (const auto& scan : frame.scans) map->insertObservation(usableScan(*scan), pose);
  }
  if (reader.statistics().scans == 0)
    throw Error(setup.rawlog.file,
                "has no 2D laser scan to build a map from; expected [rawlog] map = none or a file",
                Error::Kind::Run);
  return map;
}

/** Goals and sensors as the recorded run had them. */
void prepare(NavigationCycle& cycle, const RawlogSetup& setup) {
  cycle.setGoals(setup.scenario.goals);
  for (const auto& laser : setup.lasers) cycle.expectSensor(SensorKind::Laser, laser.first);
  if (!setup.navigation.depth.enabled) return;
  for (const auto& camera : setup.cameras) cycle.expectSensor(SensorKind::Camera, camera.first);
}

void takeOver(const RawlogStatistics& statistics, RawlogFindings& findings) {
  findings.records = static_cast<long>(statistics.entries);
  findings.frames = static_cast<long>(statistics.frames);
  findings.scans = static_cast<long>(statistics.scans);
  findings.depthFrames = static_cast<long>(statistics.depthFrames);
  findings.droppedDepthFrames = static_cast<long>(statistics.droppedDepthFrames);
  findings.firstDroppedDepth = statistics.firstDroppedDepth;
  findings.unusableBeams_percent = statistics.unusableBeams_percent();
  findings.hasOdometry = statistics.hasOdometry;
  if (statistics.truncated)
    findings.truncatedAtRecord = static_cast<long>(statistics.truncatedAtRecord);
  for (const auto& jump : statistics.clockJumps)
    findings.clockJumpsAtRecords.push_back(static_cast<long>(jump.record));
}

/** Sums up how the planner's commands differ from what the robot did. */
struct Comparison {
  double speed = 0.0, yawRate = 0.0, slower = 0.0;
  long cycles = 0;

  void add(const CycleRecord& record, const RobotLimits& limits) {
    const auto chosen = chosenVelocity(record);
    const double difference = speedOf(chosen) - speedOf(record.twist, limits);
    speed += std::abs(difference);
    yawRate += std::abs(chosen.omega - record.twist.omega);
    slower += difference <= -0.1;
    ++cycles;
  }
  void finish(RawlogFindings& findings) const {
    const double n = std::max(1.0, static_cast<double>(cycles));
    findings.speedDifferenceMean_mps = speed / n;
    findings.yawRateDifferenceMean_radps = yawRate / n;
    findings.slowerThanRecorded_percent = 100.0 * slower / n;
  }
};

std::string warnings(const RawlogFindings& findings) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  if (findings.truncatedAtRecord)
    add("the log is truncated: evaluated up to record " +
        std::to_string(*findings.truncatedAtRecord));
  if (findings.droppedDepthFrames > 0)
    add(std::to_string(findings.droppedDepthFrames) +
        " depth frames dropped, the first: " + findings.firstDroppedDepth);
  if (!findings.hasOdometry) add("the log has no odometry: the robot seems to stand");
  if (!findings.clockJumpsAtRecords.empty())
    add(std::to_string(findings.clockJumpsAtRecords.size()) + " clock jumps, the first at record " +
        std::to_string(findings.clockJumpsAtRecords.front()));
  return text;
}

}  // namespace

mrpt::math::TTwist2D chosenVelocity(const CycleRecord& record) {
  return record.motion.planned && record.dwa.best >= 0 ? record.dwa.chosenVelocity()
                                                       : record.motion.command;
}

LocalizedLog localizeLog(const RawlogSetup& setup, std::uint64_t seed) {
  setup.check();
  mrpt::system::CTicTac watch;
  auto map = setup.makeMap();
  RawlogReader reader = readerOf(setup);
  const auto localization = localizationOf(setup, map, seed);
  watch.Tic();
  RecordedPath path = recordPath(reader, *localization);
  if (setup.rawlog.map == "log") map = mapFromLog(setup, path);

  RawlogFindings findings;
  findings.log = setup.rawlog.file;
  takeOver(reader.statistics(), findings);
  findings.recorded_s = path.duration_s();
  findings.recordedPath_m = path.length_m();
  for (const auto& sample : path.samples())
    findings.meanSpread_m += sample.spread_m / static_cast<double>(path.samples().size());
  findings.wall_s = watch.Tac();
  return {std::move(path), std::move(map), std::move(findings)};
}

RunSummary evaluateLog(const RawlogSetup& setup, const LocalizedLog& log, std::uint64_t seed,
                       const RawlogObserver& observer) {
  mrpt::system::CTicTac watch;
  watch.Tic();
  NavigationParameters navigation = setup.navigation;
  if (!setup.repeatsRun())
    navigation.recovery.enabled = false;  // the robot does not do what it is told here
  NavigationCycle cycle(navigation, log.map);
  if (setup.repeatsRun()) prepare(cycle, setup);
  RunSummary summary;
  summary.seed = seed;
  summary.method = navigation.method.number;
  summary.methodName = navigation.method.name;
  summary.outcome = Outcome::Goal;
  RawlogFindings findings = log.findings;
  summary.reason = warnings(findings);

  Metrics metrics;
  Comparison comparison;
  RawlogReader reader = readerOf(setup);
  double last_s = 0.0;
  for (SensorFrame frame; reader.next(frame);) {
    if (!setup.takesRecordedPoses()) frame.mapFromRobot = log.path.poseAt(frame.time_s);
    if (!setup.repeatsRun())
      cycle.setGoals({log.path.goalAhead(frame.time_s, setup.rawlog.goalAhead_s)});
    const CycleRecord& record = cycle.step(frame);
    metrics.add(record, {frame.mapFromRobot.x, frame.mapFromRobot.y},
                speedOf(frame.twist, navigation.limits),
                frame.afterGap ? 0.0 : frame.time_s - last_s);
    last_s = frame.time_s;
    comparison.add(record, navigation.limits);
    findings.wall_s += watch.Tac();
    const double recorded_s = log.findings.recorded_s;
    const double progress = recorded_s > 0.0 ? frame.time_s / recorded_s : 1.0;  // a single frame
    if (observer && !observer({record, cycle, progress})) {
      summary.outcome = Outcome::Error;
      summary.reason = "interrupted";
      break;
    }
    watch.Tic();  // what the observer draws is not counted
  }
  metrics.finish(summary);
  comparison.finish(findings);
  summary.duration_s = last_s;
  summary.rawlog = std::move(findings);
  return summary;
}

}  // namespace bslnav
