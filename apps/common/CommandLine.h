#pragma once

#include <bslnav/config/Config.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** The options that all apps share. */
struct CommonOptions {
  std::vector<std::string> configs;
  std::vector<std::string> overrides;
  std::optional<int> method;
  std::string navigator;  ///< none: as the configuration says
  std::uint64_t seed = 1;
  std::string out;
  bool quiet = false, printConfig = false;

  /** @param defaultOut directory of the results */
  void addTo(CLI::App& app, const std::string& defaultOut);

  /** Loads the configuration files, then the method's overlay, then the overrides.
   *  @throws Error, also when there is no such method */
  void load(Config& config) const;
};

/** The file of a method's overlay, config/methods/methodN.ini. @throws Error when there is no such
 * method */
std::string methodFile(int method);

/** Runs an app: parses the command line, prints errors as one line, and returns the process's exit
 * code (0 done, 1 could not finish, 2 usage or configuration). */
int runApp(CLI::App& app, int argc, char** argv, const std::function<int()>& body);

/** Whether SIGINT or SIGTERM came since listenForInterrupts(). */
bool interrupted();
/** From now on SIGINT and SIGTERM only set a flag, so that the robot can be stopped and the records
 * kept. */
void listenForInterrupts();

/** Shows one line of progress on a terminal; nothing in a pipe or when quiet. An empty line clears
 * it. */
void showProgress(const std::string& line, bool quiet);

}  // namespace bslnav
