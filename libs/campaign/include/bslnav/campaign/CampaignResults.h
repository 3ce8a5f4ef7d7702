#pragma once

#include <bslnav/campaign/CampaignRow.h>

#include <map>
#include <string>
#include <vector>

namespace bslnav {

/** A share with its 95 % interval. */
struct Share {
  double share = 0.0, low = 0.0, high = 1.0;
};
/** Wilson's score interval (1927) of a proportion: holds for rare events, too. No trials: [0, 1].
 */
Share wilson(long hits, long trials);

/** What the rows of one entrant add up to. */
struct EntrantResult {
  int method = 0;
  std::string engine, sensors;
  long encounters = 0, goals = 0, contacts = 0, atFault = 0;
  long lapsed = 0;  ///< encounters in which the guard's promise did not always hold
  std::vector<double> times_s, emptyTimes_s;  ///< to the goal; with nobody there
  std::vector<double> clearances_m;           ///< least to people, never negative
  std::vector<double> impacts_mps;            ///< the robot's speed in contacts at fault
  std::vector<double> toYardstick;            ///< time with nobody there over the yardstick's
  double lapse_s = 0.0, standing_s = 0.0;     ///< sums
  std::map<std::string, std::pair<long, long>> families;  ///< contacts, and those at fault

  /** "Method 5, dwa, both". */
  std::string name() const;
  /** Share of the encounters without contact that ended at the goal. */
  double goalShareWithoutContact() const;
};

/** @returns one result an entrant, in the order in which they come */
std::vector<EntrantResult> resultsOf(const std::vector<CampaignRow>& rows);

/** Tables in Markdown: entrants, and contacts by family. */
std::string campaignTables(const std::vector<EntrantResult>& results);
/** The same numbers as JSON. */
std::string campaignJson(const std::vector<EntrantResult>& results);
/** Writes figure-faults.png (mean time to the goal against the rate of contacts at fault),
 * figure-times.png and figure-clearances.png (how both are distributed).
 *  @returns their paths  @throws Error (Run) when one cannot be written */
std::vector<std::string> saveCampaignFigures(const std::vector<EntrantResult>& results,
                                             const std::string& directory);

}  // namespace bslnav
