#include <bslnav/evaluation/RunTrace.h>
#include <bslnav/planning/RobotLimits.h>

#include <cmath>

namespace bslnav {

void RunTrace::observe(const SimulationMoment& moment, const std::vector<double>& instants_s) {
  const SimulationState& truth = moment.truth;
  if (firstPath.empty()) firstPath = moment.record.path;
  if (!positions.empty())
    driven_m_ += std::hypot(truth.pose.x - lastPose.x, truth.pose.y - lastPose.y);
  lastPose = truth.pose;
  lastPeople = truth.people;
  walks.resize(truth.people.size());
  walkStarts.resize(truth.people.size());
  if (thinning_.keepsNext()) keep(moment);
  if (thinning_.isFull(positions.size())) halve();
  const std::size_t next = snapshots.size();
  if (next >= instants_s.size() || truth.time_s < instants_s[next] - 1e-6) return;
  std::vector<SnapshotPerson> people;
  for (const auto& person : truth.people) people.push_back({person.position, person.radius_m});
  const Surroundings& surroundings = moment.cycle.surroundings();
  snapshots.push_back({moment.record, surroundings.localCosts(), std::move(people), {}});
  if (surroundings.people()) snapshots.back().frontier = surroundings.people()->frontier();
}

void RunTrace::keep(const SimulationMoment& moment) {
  const SimulationState& truth = moment.truth;
  distance_m.push_back(driven_m_);
  positions.emplace_back(truth.pose.x, truth.pose.y);
  time_s.push_back(truth.time_s);
  speed_mps.push_back(speedOf(truth.twist));
  command_mps.push_back(speedOf(moment.record.motion.command));
  clearance_m.push_back(truth.clearanceToPeople_m);
  for (std::size_t i = 0; i < walks.size(); ++i) {
    walks[i].push_back(truth.people[i].position);
    if (truth.people[i].started && !walkStarts[i]) walkStarts[i] = positions.size() - 1;
  }
}

void RunTrace::halve() {
  for (auto* values : {&time_s, &speed_mps, &command_mps, &clearance_m, &distance_m})
    Thinning::halve(*values);
  Thinning::halve(positions);
  for (auto& walk : walks) Thinning::halve(walk);
  for (auto& start : walkStarts)
    if (start) *start = *start / 2;
}

}  // namespace bslnav
