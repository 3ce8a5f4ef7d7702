#include "CampaignOptions.h"

#include <bslnav/config/Error.h>

#include <set>
#include <sstream>

#include "Engines.h"

namespace bslnav {
namespace {

const char* const kLaser = "laser";
const char* const kDepth = "depth";

template <typename Value>
void requireEachOnce(const std::string& option, const std::vector<Value>& values) {
  if (std::set<Value>(values.begin(), values.end()).size() != values.size())
    throw Error(option, "expected each one once");
}

/** Why there is no such entrant; empty when there is. */
std::string reasonAgainst(int method, const std::string& sensors) {
  if (sensors == kLaser && (method == 3 || method == 4))
    return "its blind spots come from a depth camera";
  if (sensors == kDepth && method < 3) return "it sees by a laser alone";
  return "";
}

Entrant makeEntrant(const CampaignOptions& options, int method, const std::string& engineWord,
                    const std::string& sensors, EncounterParameters& encounters) {
  const Engine& engine = engineOf(engineWord);
  CommonOptions common = options.common;
  common.configs.insert(common.configs.begin(), dataDirectory() + "/config/campaign.ini");
  for (const auto& file : engine.files()) common.configs.push_back(file);
  std::vector<std::string> overrides = engine.overrides;
  if (sensors == kLaser) overrides.emplace_back("depth.enabled=false");
  common.overrides.insert(common.overrides.begin(), overrides.begin(), overrides.end());
  common.method = method;

  Entrant entrant{method, engineWord, sensors, {}, ""};
  Config config;
  config.bind("campaign", "The people of a campaign's encounters.", encounters);
  entrant.setup.bind(config);
  common.load(config);
  encounters.check();
  if (sensors == kDepth) entrant.setup.lasers.clear();
  std::ostringstream ini;
  config.print(ini);
  entrant.configuration = ini.str();
  return entrant;
}

}  // namespace

void CampaignOptions::addTo(CLI::App& command) {
  common.addTo(command, "out/campaign");
  for (const char* name : {"--method", "--navigator", "--print-config"})
    command.remove_option(command.get_option(name));
  command.add_option("--method,--methods", methods, "methods to compare")->capture_default_str();
  command.add_option("--engine,--engines", engines, "what chooses velocities, on which robot")
      ->check(CLI::IsMember(engineWords()))
      ->capture_default_str();
  command.add_option("--sensors", sensors, "what the robot has: laser, depth, both")
      ->check(CLI::IsMember({kLaser, kDepth, "both"}))
      ->capture_default_str();
  command.add_option("--encounters", encounters, "encounters an entrant; families take turns")
      ->check(CLI::Range(1, 100000000))
      ->capture_default_str();
  command
      .add_option("--empty-every", emptyEvery,
                  "drive every so manyth encounter with nobody there, too; 0: none")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command.add_option("--jobs", jobs, "runs at a time; 0 for one a core; the results are the same")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command
      .add_option("--replay", replay,
                  "drive this one encounter alone, and leave its records and pictures")
      ->check(CLI::Range(0, 100000000));
}

Campaign makeCampaign(const CampaignOptions& options, std::vector<std::string>& leftOut) {
  requireEachOnce("--method", options.methods);
  requireEachOnce("--engine", options.engines);
  requireEachOnce("--sensors", options.sensors);
  Campaign campaign;
  campaign.seed = options.common.seed;
  campaign.count = options.encounters;
  campaign.emptyEvery = options.emptyEvery;
  for (const int method : options.methods)
    for (const auto& engine : options.engines)
      for (const auto& sensors : options.sensors) {
        const std::string reason = reasonAgainst(method, sensors);
        if (reason.empty())
          campaign.entrants.push_back(
              makeEntrant(options, method, engine, sensors, campaign.encounters));
        else
          leftOut.push_back("Method " + std::to_string(method) + " with " + sensors + ": " +
                            reason);
      }
  if (campaign.entrants.empty())
    throw Error("--method, --sensors", "no entrant is left (" + leftOut.front() + ")");
  return campaign;
}

}  // namespace bslnav
