#pragma once

#include <bslnav/campaign/CampaignRow.h>
#include <bslnav/campaign/Encounter.h>
#include <bslnav/evaluation/ParallelWork.h>
#include <bslnav/evaluation/SimulationSetup.h>

#include <functional>
#include <string>
#include <vector>

namespace bslnav {

/** One who drives through all encounters: a method on an engine, with a robot and its sensors. */
struct Entrant {
  int method = 0;
  std::string engine, sensors;  ///< for tables
  SimulationSetup setup;        ///< without world, start and goal
  std::string configuration;    ///< the effective one, as an INI file
};

/** A campaign: entrants that meet the same encounters. */
struct Campaign {
  std::vector<Entrant> entrants;
  EncounterParameters encounters;
  std::uint64_t seed = 1;
  long count = 0;       ///< encounters
  long emptyEvery = 1;  ///< every so manyth encounter is driven with nobody there, too; 0: none

  /** Runs: those of encounter 0 by entrant, then those of encounter 1, ... */
  long runs() const { return count * static_cast<long>(entrants.size()); }
  /** What must be the same for rows to belong together, as text. */
  std::string plan() const;
};

/** What an entrant drives in an encounter. */
SimulationSetup setupOf(const Entrant& entrant, const Encounter& encounter);

/** Does one run of a campaign. @param run from 0 to runs() - 1 */
CampaignRow runOne(const Campaign& campaign, long run);

/** Which runs are this process's: those with run % size == rank. */
struct Shard {
  long rank = 0, size = 1;
};

/** Does the runs of a shard that are not done yet, on several threads, and hands out their rows in
 * order. They do not depend on the number of jobs, nor on how the runs are shared out.
 *  @param done how many of the shard's runs are done already: always the first ones
 *  @param jobs threads; 0 for one a core
 *  @returns how many are done now */
long runShard(const Campaign& campaign, const Shard& shard, long done, int jobs,
              const std::function<void(const CampaignRow&)>& take, const WorkWatch& watch = {});

}  // namespace bslnav
