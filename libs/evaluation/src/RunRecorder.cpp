#include <bslnav/config/Error.h>
#include <bslnav/config/Version.h>
#include <bslnav/evaluation/RunRecorder.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

namespace bslnav {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kCyclesHeader =
    "cycle,time_s,x_m,y_m,heading_rad,true_x_m,true_y_m,true_heading_rad,speed_mps,yaw_rate_radps,"
    "command_speed_mps,command_yaw_rate_radps,mode,health,reason,beams,dropped_beams,blind_spots,"
    "replanned,path_points,"
    "candidates_admissible,chosen_speed_mps,chosen_yaw_rate_radps,c_pos_m,c_gol_m,c_dan,c_vel_spm,"
    "cost,lateral_mps,command_lateral_mps,guard_bound_mps,guard_slack_m,guard_reach_at_stop_m,"
    "guard_impact_mps,guard_binding,guard_binding_x_m,guard_binding_y_m,guard_hidden,guard_seen,"
    "guard_lapse\n";
constexpr const char* kCandidatesHeader =
    "cycle,speed_mps,yaw_rate_radps,verdict,c_pos_m,c_gol_m,c_dan,c_vel_spm,cost,lateral_mps\n";

std::string row(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string row(const char* format, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, format);
  const int written = std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return {buffer, static_cast<std::size_t>(std::min<int>(written, sizeof buffer - 1))};
}

std::string chosenCandidate(const CycleRecord& record) {
  if (!record.motion.planned) return ",,,,,,,";
  int admissible = 0;
  for (const Candidate& c : record.dwa.candidates)
    admissible += c.verdict == Candidate::Verdict::Admissible;
  if (record.dwa.best < 0) return row("%d,,,,,,,", admissible);
  const Candidate& best = record.dwa.candidates[static_cast<std::size_t>(record.dwa.best)];
  return row("%d,%.4f,%.5f,%.4f,%.4f,%.4f,%.4f,%.4f", admissible, best.v_mps, best.w_radps,
             best.terms.path, best.terms.goal, best.terms.danger, best.terms.velocity, best.total);
}

/** The guard's certificate; empty cells without a guard. */
std::string certificate(const GuardRecord& g) {
  if (!g.active) return ",,,,,,,,,";
  const std::string binding = g.binding ? row("%s,%.3f,%.3f", nameOf(g.binding->kind),
                                              double{g.binding->x_m}, double{g.binding->y_m})
                                        : ",,";
  return row("%.3f,%.3f,%.3f,%.3f,%s,%d,%d,%s", g.bound_mps, g.slack_m, g.reachAtStop_m,
             g.impact_mps, binding.c_str(), g.hidden, g.seen, nameOf(g.lapse));
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }
Json toJson(const Percentiles& p) { return {{"p50", p.p50}, {"p99", p.p99}, {"max", p.max}}; }

Json toJson(const GuardFindings& g) {
  return {{"scans", g.scans},
          {"frontiers", g.frontiers},
          {"jumps", g.jumps},
          {"jumps_plausible", g.plausible},
          {"jumps_too_far", g.tooFar},
          {"jumps_nobody_fits", g.nobodyFits},
          {"jumps_seen_empty", g.seenEmpty},
          {"driving_cycles", g.drivingCycles},
          {"bound_exceeded_cycles", g.exceededCycles},
          {"bound_exceeded_most_mps", g.mostExceeded_mps}};
}

Json toJson(const RawlogFindings& f) {
  return {{"log", f.log},
          {"records", f.records},
          {"frames", f.frames},
          {"scans", f.scans},
          {"depth_frames", f.depthFrames},
          {"dropped_depth_frames", f.droppedDepthFrames},
          {"recorded_s", f.recorded_s},
          {"recorded_path_m", f.recordedPath_m},
          {"unusable_beams_percent", f.unusableBeams_percent},
          {"has_odometry", f.hasOdometry},
          {"truncated_at_record", f.truncatedAtRecord ? Json(*f.truncatedAtRecord) : Json(nullptr)},
          {"clock_jumps_at_records", f.clockJumpsAtRecords},
          {"localization_spread_mean_m", f.meanSpread_m},
          {"speed_difference_mean_mps", f.speedDifferenceMean_mps},
          {"yaw_rate_difference_mean_radps", f.yawRateDifferenceMean_radps},
          {"slower_than_recorded_percent", f.slowerThanRecorded_percent},
          {"guard", f.guard ? toJson(*f.guard) : Json(nullptr)},
          {"wall_s", f.wall_s},
          {"times_faster_than_recording", f.recorded_s / f.wall_s}};
}

Json toJson(const RunSummary& s) {
  Json json{{"outcome", nameOf(s.outcome)},
            {"reason", s.reason},
            {"time_to_goal_s", orNull(s.timeToGoal_s)},
            {"duration_s", s.duration_s},
            {"path_length_m", s.pathLength_m},
            {"mean_speed_mps", s.meanSpeed_mps},
            {"contact", s.contact},
            {"at_fault", s.atFault},
            {"impact_speed_mps", orNull(s.impactSpeed_mps)},
            {"min_clearance_m", orNull(s.minClearance_m)},
            {"goal_moved", s.goalMoved},
            {"time_stopped_s", s.timeStopped_s},
            {"blind_spots_mean", s.blindSpotsMean},
            {"cycles", s.cycles},
            {"blocked_cycles", s.blockedCycles},
            {"unhealthy_cycles", s.unhealthyCycles},
            {"guard_lapse_s", s.lapse_s},
            {"dropped_beams", s.droppedBeams},
            {"dropped_depth_frames", s.droppedDepthFrames},
            {"sensor_problem", s.sensorProblem},
            {"cycle_ms", toJson(s.cycle_ms)},
            {"stages_ms",
             {{"blind_spots", toJson(s.blindSpots_ms)},
              {"costmap", toJson(s.costmap_ms)},
              {"people", toJson(s.people_ms)},
              {"global_plan", toJson(s.globalPlan_ms)},
              {"motion", toJson(s.motion_ms)}}},
            {"seed", s.seed},
            {"method", s.method},
            {"method_name", s.methodName},
            {"version", version()}};
  if (s.rawlog) json["rawlog"] = toJson(*s.rawlog);
  return json;
}

void close(std::ofstream& file, const std::string& path) {
  file.close();
  if (!file) throw Error(path, "not written in full; is the disk full?", Error::Kind::Run);
}

}  // namespace

void writeFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!file) throw Error(path, "cannot be written", Error::Kind::Run);
  file << text;
  close(file, path);
}

RunRecorder::RunRecorder(const std::string& directory, const Config& config)
    : directory_(directory) {
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem) throw Error(directory, "cannot be made: " + problem.message(), Error::Kind::Run);
  std::ostringstream ini;
  config.print(ini);
  writeFile(path("config.ini"), ini.str());
  cycles_.open(path("cycles.csv"), std::ios::binary);
  cycles_ << kCyclesHeader;
  if (!cycles_) throw Error(path("cycles.csv"), "cannot be written", Error::Kind::Run);
}

void RunRecorder::recordCandidates() {
  candidates_.open(path("candidates.csv"), std::ios::binary);
  candidates_ << kCandidatesHeader;
  if (!candidates_) throw Error(path("candidates.csv"), "cannot be written", Error::Kind::Run);
}

void RunRecorder::write(const CycleRecord& r, const mrpt::math::TPose2D& truePose) {
  cycles_
      << row("%d,%.3f,%.4f,%.4f,%.5f,%.4f,%.4f,%.5f,%.4f,%.5f,%.4f,%.5f,%s,%s,%s,%d,%d,%zu,%d,%zu,",
             r.index, r.time_s, r.mapFromRobot.x, r.mapFromRobot.y, r.mapFromRobot.phi, truePose.x,
             truePose.y, truePose.phi, r.twist.vx, r.twist.omega, r.motion.command.vx,
             r.motion.command.omega, nameOf(r.motion.mode), nameOf(r.health), reasonOf(r).c_str(),
             r.beams, r.droppedBeams, r.blindSpots.size(), int{r.replanned}, r.path.size())
      << chosenCandidate(r) << row(",%.4f,%.4f,", r.twist.vy, r.motion.command.vy)
      << certificate(r.guard) << '\n'
      << std::flush;  // whatever happens to this process, the row is kept
  if (!cycles_) throw Error(path("cycles.csv"), "cannot be written in full", Error::Kind::Run);
  if (!candidates_.is_open() || !r.motion.planned) return;
  static constexpr const char* kVerdicts[] = {"admissible",  "obstacle",      "unknown",
                                              "oscillation", "out_of_window", "guarded"};
  for (const Candidate& c : r.dwa.candidates)
    candidates_ << row("%d,%.4f,%.5f,%s,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", r.index, c.v_mps,
                       c.w_radps, kVerdicts[static_cast<int>(c.verdict)], c.terms.path,
                       c.terms.goal, c.terms.danger, c.terms.velocity, c.total, c.vy_mps);
}

void RunRecorder::finish(const RunSummary& summary) {
  close(cycles_, path("cycles.csv"));
  if (candidates_.is_open()) close(candidates_, path("candidates.csv"));
  // Names from files and configurations may be anything; JSON is UTF-8.
  writeFile(path("summary.json"),
            toJson(summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace bslnav
