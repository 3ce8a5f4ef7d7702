#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "AppProcess.h"

namespace bslnav::test {

std::string readFile(const std::string& path);

/** A room of 6 m x 4 m around the start, one laser, and a goal 2 m ahead: a run takes tenths of a
 * second. */
extern const char* const kRoom;
/** The paper's case S1. */
extern const char* const kS1;

/** Runs the programs in a directory of the test's own. */
class AppTest : public testing::Test {
 protected:
  AppTest();

  AppResult run(const Arguments& arguments, const std::string& program = "bslnav") const;
  /** Runs a configuration with its results in out(name). */
  AppResult drive(const std::string& config, Arguments arguments = {},
                  const std::string& name = "out") const;

  std::string path(const std::string& name) const { return directory_ + "/" + name; }
  std::string out(const std::string& file, const std::string& name = "out") const {
    return path(name) + "/" + file;
  }
  /** Writes a file into the test's directory. @returns its path */
  std::string write(const std::string& name, const std::string& text) const;
  nlohmann::json summary(const std::string& name = "out") const;

 private:
  std::string directory_;
};

bool exists(const std::string& path);
/** Rows of a CSV file without its header. */
std::size_t rowsOf(const std::string& csv);
/** A summary without what depends on the machine: keys in _ms, and how fast a log was evaluated. */
nlohmann::json withoutTimings(nlohmann::json summary);

}  // namespace bslnav::test
