#include <bslnav/config/Error.h>
#include <bslnav/evaluation/RunMemory.h>
#include <bslnav/pictures/TimeChart.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace bslnav {

double residentMemory_MB(pid_t process) {
  // proc(5): the second field of statm is the resident set, in pages.
  std::ifstream statm("/proc/" + std::to_string(process) + "/statm");
  long size = 0, resident = 0;
  if (!(statm >> size >> resident)) return std::numeric_limits<double>::quiet_NaN();
  return 1e-6 * static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

RunMemory::RunMemory(const std::string& directory, double period_s)
    : directory_(directory), period_s_(period_s), file_(directory + "/memory.csv") {
  file_ << "time_s,driven_m,program,resident_mb\n" << std::flush;
  if (!file_) throw Error(directory_ + "/memory.csv", "cannot be written", Error::Kind::Run);
}

void RunMemory::observe(double time_s, const mrpt::math::TPoint2D& position,
                        const std::function<std::vector<Program>()>& programs) {
  if (last_) way_m_ += (position - *last_).norm();
  last_ = position;
  constexpr double kRounding_s = 1e-6;  // of times that are sums of periods
  if (time_s < due_s_ - kRounding_s) return;
  while (due_s_ <= time_s + kRounding_s) due_s_ += period_s_;
  sample(time_s, programs());
}

void RunMemory::sample(double time_s, const std::vector<Program>& programs) {
  time_s_.push_back(time_s);
  driven_m_.push_back(way_m_);
  for (const auto& [name, process] : programs) {
    const double resident_MB = residentMemory_MB(process);
    series_[name].time_s.push_back(time_s);
    series_[name].resident_MB.push_back(resident_MB);
    char row[64];
    std::snprintf(row, sizeof row, "%.1f,%.2f,", time_s, way_m_);
    file_ << row << name;
    std::snprintf(row, sizeof row, ",%.3f\n", resident_MB);
    file_ << row << std::flush;
  }
  if (!file_)
    throw Error(directory_ + "/memory.csv", "cannot be written in full", Error::Kind::Run);
}

std::string RunMemory::save(const std::string& title) const {
  const std::string path = directory_ + "/memory.png";
  char subtitle[64] = "";
  if (!time_s_.empty())
    std::snprintf(subtitle, sizeof subtitle, "%.0f s, %.0f m driven", time_s_.back(),
                  driven_m_.back());
  TimeChart chart(title, subtitle, "time [s]");
  chart.panel("resident memory [MB]");
  for (const auto& [name, series] : series_) chart.series(name, series.time_s, series.resident_MB);
  chart.panel("driven [m]");
  chart.series("", time_s_, driven_m_);
  chart.save(path);
  return path;
}

}  // namespace bslnav
