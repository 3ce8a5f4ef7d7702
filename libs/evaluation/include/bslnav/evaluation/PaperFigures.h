#pragma once

#include <bslnav/evaluation/NominalRuns.h>
#include <bslnav/pictures/Picture.h>

#include <vector>

namespace bslnav {

/** One page about a case: the path that each method drove, and below it their cost maps at the same
 * instants, a row for each method. At most 1800 pixels wide.
 *  @param runs of one case, at least one */
Picture caseFigure(const std::vector<NominalRun>& runs);

/** Speed, and where there are people the clearance to them, over the distance driven, for every
 * method; where people started and where contact was made. @param runs of one case, at least one */
Picture speedFigure(const std::vector<NominalRun>& runs);

}  // namespace bslnav
