#pragma once

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <string>

namespace bslnav {

/** The directory with the images that a log stores outside, by MRPT's convention: beside it,
 * `<log without extension>_Images`, or else `Images`. An absolute path. */
std::string imagesDirectoryOf(const std::string& log);

/** Frees the points of a depth observation and unmarks them, also where a file outside holds them:
 * the range image says the same in a tenth of the memory. */
void forgetPoints(mrpt::obs::CObservation3DRangeScan& depth);

/** Makes sure that a depth observation has its range image in memory; reads it from
 * `imagesDirectory` where the log only names a file.
 *  @return why there is none; empty when there is one */
std::string loadRangeImage(mrpt::obs::CObservation3DRangeScan& depth,
                           const std::string& imagesDirectory);

}  // namespace bslnav
