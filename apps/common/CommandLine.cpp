#include "CommandLine.h"

#include <bslnav/config/Error.h>
#include <bslnav/config/Version.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <opencv2/core/utility.hpp>

namespace bslnav {
namespace {

// Set by the signal handler and read by any thread: a lock-free atomic may be touched there.
std::atomic<bool> interruptFlag{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void CommonOptions::addTo(CLI::App& app, const std::string& defaultOut) {
  out = defaultOut;
  app.set_version_flag("--version", version());
  app.add_option("CONFIG", configs, "configuration files (INI); later ones override earlier ones");
  app.add_option("--method", method,
                 "method number: short for config/methods/methodN.ini after the other files");
  app.add_option("--navigator", navigator,
                 "what chooses velocities: dwa, ptg or mrpt; short for --set navigator.type=...");
  app.add_option("--set", overrides,
                 "section.key=value, overrides the files; may be given several times")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  const CLI::Validator wholeNumber(
      [](const std::string& word) {
        const bool digits = word.find_first_not_of("0123456789") == std::string::npos;
        return digits && word.size() < 19 ? std::string()
                                          : "expected a whole number from 0, not " + word;
      },
      "");
  app.add_option("--seed", seed, "seed of all randomness")
      ->check(wholeNumber)
      ->capture_default_str();
  app.add_option("--out", out, "directory for the results")->capture_default_str();
  app.add_flag("--quiet", quiet, "print errors only");
  app.add_flag("--print-config", printConfig,
               "print every section and key with its value, and end");
}

std::string methodFile(int method) {
  std::string file = dataDirectory() + "/config/methods/method" + std::to_string(method) + ".ini";
  if (!std::filesystem::exists(file))
    throw Error("--method " + std::to_string(method),
                "no such method; expected a number with a file " + file);
  return file;
}

void CommonOptions::load(Config& config) const {
  std::vector<std::string> files = configs;
  if (method) files.push_back(methodFile(*method));
  std::vector<std::string> settings;
  if (!navigator.empty()) settings.push_back("navigator.type=" + navigator);
  settings.insert(settings.end(), overrides.begin(), overrides.end());
  config.load(files, settings);
}

int runApp(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  cv::setNumThreads(
      1);  // its thread pool gains nothing on grids this small, and one core is to be enough
  try {
    app.parse(argc, argv);
    return body();
  } catch (const CLI::ParseError& problem) {
    const int code = app.exit(problem);
    return code == 0 ? 0 : 2;
  } catch (const Error& problem) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), problem.what());
    return problem.exitCode();
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), problem.what());
    return 1;
  }
}

bool interrupted() { return interruptFlag; }

void listenForInterrupts() {
  std::signal(SIGXFSZ, SIG_IGN);  // files that must not grow any more are an error like a full disk
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interruptFlag = true; });
}

void showProgress(const std::string& line, bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
}

}  // namespace bslnav
