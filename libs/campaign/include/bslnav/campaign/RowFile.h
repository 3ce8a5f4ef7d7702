#pragma once

#include <bslnav/campaign/CampaignRow.h>

#include <fstream>
#include <string>
#include <vector>

namespace bslnav {

/** A growing results.csv: a campaign that was stopped goes on where it ended. */
class RowFile {
 public:
  /** Opens or makes the file, and drops a last line that is not whole.
   *  @throws Error (Run) when it cannot, or when the file is something else */
  explicit RowFile(const std::string& path);

  /** How many rows it has. */
  long rows() const { return rows_; }
  /** Adds a row, which is in the file when this returns. @throws Error (Run) when it cannot */
  void append(const CampaignRow& row);

 private:
  std::string path_;
  std::ofstream file_;
  long rows_ = 0;
};

/** All rows of a file. @throws Error (Run) naming file and row */
std::vector<CampaignRow> readRows(const std::string& path);

/** The file of one shard: results.csv when there is but one, else results.RANK-of-SIZE.csv. */
std::string shardFile(const std::string& directory, long rank, long size);

/** Makes results.csv from the files of all shards, in the order in which one process would have
 * written it. @throws Error (Run) */
void mergeShards(const std::string& directory, long size);

/** Keeps the plan of a campaign beside its rows as plan.ini.
 *  @throws Error when rows of another plan are there */
void keepPlan(const std::string& directory, const std::string& plan);

}  // namespace bslnav
