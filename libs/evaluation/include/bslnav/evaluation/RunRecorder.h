#pragma once

#include <bslnav/config/Config.h>
#include <bslnav/evaluation/RunSummary.h>

#include <fstream>
#include <string>

namespace bslnav {

/** Leaves a run's files in a directory: `config.ini` at the start, `cycles.csv` row by row,
 * `summary.json` at the end.
 *
 * Rows are written as they come, so that an interrupted run keeps its records. Only the fields
 * `*_ms`, `wall_s` and `times_faster_than_recording` of the summary depend on the machine. */
class RunRecorder {
 public:
  /** Makes the directory. @throws Error (Run) when it cannot be written */
  RunRecorder(const std::string& directory, const Config& config);

  /** One row of cycles.csv. @param truePose where the robot really is, where that is known
   *  @throws Error (Run) when it cannot be written */
  void write(const CycleRecord& record, const mrpt::math::TPose2D& truePose);

  /** Also writes one row a candidate to candidates.csv: all that the planner considered (about 80
   * kB a cycle).
   *  @throws Error (Run) when it cannot be written */
  void recordCandidates();

  /** Writes summary.json. @throws Error (Run) when any of the files could not be written in full */
  void finish(const RunSummary& summary);

  const std::string& directory() const { return directory_; }
  std::string path(const std::string& name) const { return directory_ + "/" + name; }

 private:
  std::string directory_;
  std::ofstream cycles_, candidates_;
};

/** Writes text to a file. @throws Error (Run) naming the file when it cannot */
void writeFile(const std::string& path, const std::string& text);

}  // namespace bslnav
