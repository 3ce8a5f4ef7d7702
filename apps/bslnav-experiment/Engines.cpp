#include "Engines.h"

#include <bslnav/config/Config.h>

#include <algorithm>

namespace bslnav {

const std::vector<Engine>& engines() {
  const auto mrpt = [](const std::string& method) {
    return std::vector<std::string>{"navigator.type=mrpt", "navigator.mrpt_method=" + method};
  };
  static const std::vector<Engine> all = {
      {"dwa", "dwa", {"navigator.type=dwa"}},
      {"ptg", "ptg", {"navigator.type=ptg"}},
      {"dwa-holonomic", "dwa, holonomic", {"navigator.type=dwa"}, true},
      {"ptg-holonomic", "ptg, holonomic", {"navigator.type=ptg"}, true},
      {"mrpt-nd", "mrpt ND", mrpt("CHolonomicND")},
      {"mrpt-fulleval", "mrpt FullEval", mrpt("CHolonomicFullEval")}};
  return all;
}

std::vector<std::string> engineWords() {
  std::vector<std::string> words;
  for (const Engine& engine : engines()) words.push_back(engine.word);
  return words;
}

const Engine& engineOf(const std::string& word) {
  return *std::find_if(engines().begin(), engines().end(),
                       [&word](const Engine& engine) { return engine.word == word; });
}

std::vector<std::string> Engine::files() const {
  if (!holonomic) return {};
  return {dataDirectory() + "/config/robots/holonomic.ini"};
}

}  // namespace bslnav
