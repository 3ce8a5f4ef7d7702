#pragma once

#include <bslnav/evaluation/PaperResults.h>

#include <string>
#include <vector>

namespace bslnav {

/** The nominal runs beside the paper's numbers, as a Markdown table; where Methods 2 and 4 both
 * ran, also by how much Method 4 is faster. */
std::string nominalTable(const std::vector<PaperResult>& results);

/** What the seeds add up to, one line for each case and method, as a Markdown table. */
std::string seedsTable(const std::vector<PaperResult>& results);

/** Both tables with their headings. */
std::string paperTables(const std::vector<PaperResult>& results, const SeedRange& seeds);

}  // namespace bslnav
