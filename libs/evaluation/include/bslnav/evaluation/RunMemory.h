#pragma once

#include <mrpt/math/TPoint2D.h>
#include <sys/types.h>

#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** How much memory a process holds (its resident set); NaN when there is no such process. */
double residentMemory_MB(pid_t process);

/** How much memory the programs of a drive hold, and how far it has gone: memory.csv, a row a
 * program and sample. */
class RunMemory {
 public:
  struct Program {
    std::string name;
    pid_t process;  ///< below 1: it does not run now
  };

  /** @param period_s from one sample to the next
   *  @throws Error (Run) when the file cannot be written */
  RunMemory(const std::string& directory, double period_s);

  /** To be called every cycle. @param programs asked for when a sample is due
   *  @throws Error (Run) when the file cannot be written */
  void observe(double time_s, const mrpt::math::TPoint2D& position,
               const std::function<std::vector<Program>()>& programs);
  /** Writes memory.png. @returns its path @throws Error (Run) when it cannot be written */
  std::string save(const std::string& title) const;

 private:
  void sample(double time_s, const std::vector<Program>& programs);

  struct Series {
    std::vector<double> time_s, resident_MB;
  };

  std::string directory_;
  double period_s_, due_s_ = 0.0, way_m_ = 0.0;
  std::optional<mrpt::math::TPoint2D> last_;
  std::ofstream file_;
  std::map<std::string, Series> series_;
  std::vector<double> time_s_, driven_m_;
};

}  // namespace bslnav
