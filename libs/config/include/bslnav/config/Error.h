#pragma once

#include <stdexcept>
#include <string>

namespace bslnav {

/** What every start-up or input/output failure is thrown as: where it is and what was expected
 * there.
 *
 * What happens in normal operation (no path, no admissible velocity, a bad beam) is a value, never
 * an Error. */
class Error : public std::runtime_error {
 public:
  enum class Kind {
    Configuration,  ///< usage, configuration or a missing input file: refused before anything moves
                    ///< (exit code 2)
    Run             ///< the run itself could not be done or finished (exit code 1)
  };

  /** @param where file, and section and key or record number in it, for example "s1.ini [dwa]
   * horizon_s"
   *  @param problem what is wrong and what was expected instead */
  Error(const std::string& where, const std::string& problem, Kind kind = Kind::Configuration)
      : std::runtime_error(where + ": " + problem), kind_(kind) {}

  Kind kind() const { return kind_; }
  /** 2 for configuration, 1 for a failed run. */
  int exitCode() const { return kind_ == Kind::Configuration ? 2 : 1; }

 private:
  Kind kind_;
};

}  // namespace bslnav
