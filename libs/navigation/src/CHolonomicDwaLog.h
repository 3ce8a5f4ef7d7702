#pragma once

#include <bslnav/planning/LocalPlanner.h>
#include <mrpt/nav/holonomic/CHolonomicFullEval.h>

namespace bslnav {

/** The scores of all paths of a PTG as MRPT's optimizer and navlog-viewer read them: of each path
 * its best speed's exp(-J / 10), 0 when none is admissible.
 *  @param result path by path, `speeds` candidates each */
mrpt::nav::CLogFileRecord_FullEval::Ptr scoresOf(const DwaResult& result, int speeds);

}  // namespace bslnav
