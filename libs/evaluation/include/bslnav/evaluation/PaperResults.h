#pragma once

#include <bslnav/evaluation/NominalRuns.h>

#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** What came out for one case by one method. */
struct PaperResult {
  std::string caseName;  ///< for example "s1"
  std::string title;     ///< the scenario's name
  int method = 0;
  std::string methodName;
  std::optional<RunSummary> nominal;  ///< none when it was stopped before
  std::vector<RunSummary> seeds;      ///< by seed
};

/** Puts the runs together: one entry for each of the cases, in their order. */
std::vector<PaperResult> paperResults(const std::vector<ExperimentCase>& cases,
                                      const std::vector<NominalRun>& nominal,
                                      const std::vector<ExperimentResult>& seeds);

/** One row for each seed of each case and method; nothing in it depends on the machine. */
std::string resultsCsv(const std::vector<PaperResult>& results);

/** The same runs as JSON, for each case and method with the nominal run, what the paper reports and
 * what the seeds add up to; nothing in it depends on the machine. */
std::string resultsJson(const std::vector<PaperResult>& results);

}  // namespace bslnav
