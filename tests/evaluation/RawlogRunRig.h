#pragma once

#include <bslnav/evaluation/RawlogRun.h>

#include "../navigation/RawlogReaderLogs.h"
#include "EvaluationRig.h"

namespace bslnav::test {

/** 181 beams over 180° to 8 m: a wall at y = 2.025 m on the left, 4 m on the right; one jump ahead.
 */
inline mrpt::obs::CObservation2DRangeScan twoWalls(double time_s) {
  auto scan = testing_logs::makeScan(time_s);
  scan.aperture = static_cast<float>(M_PI);
  scan.maxRange = 8.0f;
  scan.resizeScanAndAssign(181, 4.0f, true);
  for (int i = 90; i < 181; ++i) {
    const double range_m = 2.025 / std::sin((i - 90) * M_PI / 180.0);
    scan.setScanRange(static_cast<std::size_t>(i), static_cast<float>(std::min(8.0, range_m)));
  }
  return scan;
}

/** A robot that drives along x with 0.5 m/s for `seconds`, at 5 Hz, as single observations. */
inline testing_logs::LogWriter& addDrive(testing_logs::LogWriter& log, double seconds,
                                         double from_s = 0.0, double from_m = 0.0) {
  for (int i = 0; 0.2 * i <= seconds + 1e-9; ++i) {
    log.odometry(from_s + 0.2 * i, {from_m + 0.1 * i, 0.0, 0.0});
    log.add(twoWalls(from_s + 0.2 * i));
  }
  return log;
}

/** The same as pairs of actions and sensory frames. */
inline std::string driveInPairs(const std::string& name, double seconds) {
  testing_logs::LogWriter log(name);
  for (int i = 0; 0.2 * i <= seconds + 1e-9; ++i) {
    log.action({i == 0 ? 0.0 : 0.1, 0.0, 0.0}, mrpt::math::TTwist2D{0.5, 0.0, 0.0});
    mrpt::obs::CSensoryFrame frame;
    frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(twoWalls(0.2 * i)));
    log.add(frame);
  }
  return log.close();
}

inline RawlogSetup setupOf(const std::string& file) {
  RawlogSetup setup;
  setup.rawlog.file = file;
  setup.navigation.blindSpots.source = BlindSpotSource::ScanJumps;
  setup.navigation.limits.maxSpeed_mps = 1.0;
  setup.navigation.dwa.weights.velocity = 0.0;
  return setup;
}

/** Both passes, and what the observer saw. */
struct Evaluation {
  RunSummary summary;
  LocalizedLog log;
  std::vector<CycleRecord> records;
};

inline Evaluation evaluate(const RawlogSetup& setup) {
  LocalizedLog log = localizeLog(setup, 1);
  std::vector<CycleRecord> records;
  RunSummary summary = evaluateLog(setup, log, 1, [&](const RawlogMoment& moment) {
    records.push_back(moment.record);
    return true;
  });
  return {std::move(summary), std::move(log), std::move(records)};
}

}  // namespace bslnav::test
