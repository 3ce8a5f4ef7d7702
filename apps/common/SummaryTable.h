#pragma once

#include <bslnav/evaluation/RunSummary.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace bslnav {

/** A run in one small table, with the files it left. */
void printSummary(std::ostream& out, const std::string& name, const RunSummary& summary,
                  const std::string& directory, const std::vector<std::string>& pictures);

/** One line about where a run is. */
std::string progressLine(const CycleRecord& record);

/** 0 when the run did what was asked (a contact is a result too), 1 when it could not finish. */
int exitCodeOf(const RunSummary& summary);

}  // namespace bslnav
