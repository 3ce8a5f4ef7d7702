#include <bslnav/campaign/Campaign.h>
#include <bslnav/evaluation/SimulationRun.h>

#include <algorithm>

namespace bslnav {
namespace {

/** The least time that any planner takes with this robot, if people may be as fast as its guard
 * expects. */
std::optional<double> yardstickOf(const CornerPass& pass, const NavigationParameters& p) {
  const StoppingAbility robot =
      stoppingAbility(p.limits, p.guard, p.footprint.circumscribedRadius_m(), p.cycle.period_s);
  return fastestPass_s(pass, robot, p.limits.acceleration_mps2, p.limits.maxSpeed_mps,
                       p.guard.personSpeed_mps);
}

}  // namespace

std::string Campaign::plan() const {
  std::string text = "campaign of seed " + std::to_string(seed) + ", nobody there in every " +
                     std::to_string(emptyEvery) + "th encounter\n";
  for (const Entrant& entrant : entrants)
    text += "\n; ---- method " + std::to_string(entrant.method) + ", " + entrant.engine + ", " +
            entrant.sensors + " ----\n" + entrant.configuration;
  return text;
}

SimulationSetup setupOf(const Entrant& entrant, const Encounter& encounter) {
  SimulationSetup setup = entrant.setup;
  setup.world = encounter.world;
  setup.scenario.name = nameOf(encounter.family);
  setup.scenario.start = encounter.start;
  setup.scenario.goals = encounter.goals;
  setup.scenario.timeLimit_s = encounter.timeLimit_s;
  setup.scenario.map = "world";
  return setup;
}

CampaignRow runOne(const Campaign& campaign, long run) {
  const auto entrants = static_cast<long>(campaign.entrants.size());
  const Entrant& entrant = campaign.entrants[static_cast<std::size_t>(run % entrants)];
  CampaignRow row;
  row.encounter = run / entrants;
  const Encounter encounter = makeEncounter(campaign.encounters, campaign.seed, row.encounter);
  row.family = nameOf(encounter.family);
  row.seed = encounter.seed;
  row.method = entrant.method;
  row.engine = entrant.engine;
  row.sensors = entrant.sensors;
  SimulationSetup setup = setupOf(entrant, encounter);
  row.take(runSimulation(setup, encounter.seed));
  if (campaign.emptyEvery > 0 && row.encounter % campaign.emptyEvery == 0) {
    setup.world.pedestrians.clear();
    row.timeEmpty_s = runSimulation(setup, encounter.seed).timeToGoal_s;
    if (encounter.pass) row.yardstick_s = yardstickOf(*encounter.pass, setup.navigation);
  }
  return row;
}

long runShard(const Campaign& campaign, const Shard& shard, long done, int jobs,
              const std::function<void(const CampaignRow&)>& take, const WorkWatch& watch) {
  const long all = std::max(0L, (campaign.runs() - shard.rank + shard.size - 1) / shard.size);
  if (done >= all) return done;
  std::vector<CampaignRow> rows(static_cast<std::size_t>(all - done));
  const auto work = [&](std::size_t i) {
    rows[i] = runOne(campaign, shard.rank + (done + static_cast<long>(i)) * shard.size);
  };
  const auto progress = [&](std::size_t finished, std::size_t) {
    take(rows[finished - 1]);
    if (watch.progress)
      watch.progress(static_cast<std::size_t>(done) + finished, static_cast<std::size_t>(all));
  };
  return done + static_cast<long>(doInParallel(rows.size(), jobs, work, {watch.goOn, progress}));
}

}  // namespace bslnav
