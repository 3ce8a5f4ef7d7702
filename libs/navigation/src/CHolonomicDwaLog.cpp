#include "CHolonomicDwaLog.h"

#include <algorithm>
#include <cmath>

namespace bslnav {

mrpt::nav::CLogFileRecord_FullEval::Ptr scoresOf(const DwaResult& result, int speeds) {
  constexpr double kScale = 10.0;  // costs of a usual cycle differ by less than this
  auto record = mrpt::nav::CLogFileRecord_FullEval::Create();
  std::vector<double> scores(result.candidates.size() / static_cast<std::size_t>(speeds), 0.0);
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    const Candidate& candidate = result.candidates[i];
    if (candidate.verdict != Candidate::Verdict::Admissible) continue;
    double& score = scores[i / static_cast<std::size_t>(speeds)];
    score = std::max(score, std::exp(-candidate.total / kScale));
  }
  record->selectedTarget = 0;
  record->selectedSector = result.best < 0 ? 0 : result.best / speeds;
  record->evaluation =
      result.best < 0 ? 0.0 : scores[static_cast<std::size_t>(result.best / speeds)];
  record->dirs_eval = {scores};
  return record;
}

}  // namespace bslnav
