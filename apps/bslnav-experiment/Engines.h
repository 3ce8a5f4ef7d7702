#pragma once

#include <string>
#include <vector>

namespace bslnav {

/** What chooses velocities, and on which robot. */
struct Engine {
  std::string word, title;  ///< on the command line, in tables
  std::vector<std::string> overrides;
  bool holonomic = false;

  /** Configuration files that the engine's robot needs after the others. */
  std::vector<std::string> files() const;
};

const std::vector<Engine>& engines();
/** The words of all engines. */
std::vector<std::string> engineWords();
/** @param word one of engineWords() */
const Engine& engineOf(const std::string& word);

}  // namespace bslnav
