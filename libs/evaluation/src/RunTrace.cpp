#include <bslnav/evaluation/RunTrace.h>
#include <bslnav/planning/RobotLimits.h>

namespace bslnav {

void RunTrace::observe(const SimulationMoment& moment, const std::vector<double>& instants_s) {
  const SimulationState& truth = moment.truth;
  const mrpt::math::TPoint2D position{truth.pose.x, truth.pose.y};
  distance_m.push_back(
      positions.empty() ? 0.0 : distance_m.back() + (position - positions.back()).norm());
  positions.push_back(position);
  time_s.push_back(truth.time_s);
  speed_mps.push_back(speedOf(truth.twist));
  command_mps.push_back(speedOf(moment.record.motion.command));
  clearance_m.push_back(truth.clearanceToPeople_m);
  walks.resize(truth.people.size());
  walkStarts.resize(truth.people.size());
  for (std::size_t i = 0; i < walks.size(); ++i) {
    walks[i].push_back(truth.people[i].position);
    if (truth.people[i].started && !walkStarts[i]) walkStarts[i] = positions.size() - 1;
  }
  if (firstPath.empty()) firstPath = moment.record.path;
  lastPose = truth.pose;
  lastPeople = truth.people;
  const std::size_t next = snapshots.size();
  if (next >= instants_s.size() || truth.time_s < instants_s[next] - 1e-6) return;
  std::vector<SnapshotPerson> people;
  for (const auto& person : truth.people) people.push_back({person.position, person.radius_m});
  const Surroundings& surroundings = moment.cycle.surroundings();
  snapshots.push_back({moment.record, surroundings.localCosts(), std::move(people), {}});
  if (surroundings.people()) snapshots.back().frontier = surroundings.people()->frontier();
}

}  // namespace bslnav
