#include "ExperimentCommand.h"

#include <bslnav/config/Error.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

namespace bslnav {
namespace {

std::string durationText(double duration_s) {
  const auto whole_s = static_cast<long>(std::ceil(duration_s));
  if (whole_s < 60) return std::to_string(whole_s) + " s";
  return std::to_string(whole_s / 60) + " min " + std::to_string(whole_s % 60) + " s";
}

}  // namespace

void ExperimentOptions::addTo(CLI::App& command, std::vector<int> defaultMethods, int defaultRuns) {
  common.addTo(command, "out");
  // an experiment has several configurations; it leaves them all beside its results
  for (const char* name : {"--method", "--print-config"})
    command.remove_option(command.get_option(name));
  methods = std::move(defaultMethods);
  runs = defaultRuns;
  command.add_option("--methods", methods, "methods to compare")->capture_default_str();
  command.add_option("--runs", runs, "seeds a method, from --seed on")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command.add_option("--jobs", jobs, "runs at a time; 0 for one a core; the results are the same")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

void ExperimentOptions::check() const {
  if (std::set<int>(methods.begin(), methods.end()).size() != methods.size())
    throw Error("--methods", "expected each method once");
}

ExperimentCase loadCase(const std::string& name, const CommonOptions& options, int method) {
  CommonOptions ofMethod = options;
  ofMethod.method = method;
  SimulationSetup setup;
  Config config;
  setup.bind(config);
  ofMethod.load(config);
  std::ostringstream ini;
  config.print(ini);
  return {name, method, setup, ini.str()};
}

WorkWatch watchWork(const std::string& what, bool quiet) {
  using Clock = std::chrono::steady_clock;
  const auto progress = [what, quiet, start = Clock::now()](std::size_t done, std::size_t total) {
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
    const double left_s = elapsed_s / static_cast<double>(done) * static_cast<double>(total - done);
    showProgress(what + ": " + std::to_string(done) + " / " + std::to_string(total) + ", " +
                     durationText(left_s) + " left",
                 quiet);
  };
  return {[] { return !interrupted(); }, progress};
}

void makeDirectory(const std::string& directory) {
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem) throw Error(directory, "cannot be made: " + problem.message(), Error::Kind::Run);
}

}  // namespace bslnav
