#pragma once

#include <atomic>
#include <mutex>
#include <random>
#include <thread>

#include "PseudoTerminal.h"
#include "ScipLaser.h"

namespace bslnav::test {

/** A SCIP 2.0 laser on a pseudo-terminal, turning in real time on a thread of its own, with faults
 * on demand. All members may be called from any one thread while a driver is connected. */
class ScipEmulator {
 public:
  /** Sees nothing until it is told ranges.
   *  @param seed of the bytes of garbage */
  explicit ScipEmulator(const ScipModel& model = {}, unsigned seed = 1);
  ~ScipEmulator();

  /** What a driver opens. */
  const std::string& path() const { return line_.path(); }
  const ScipModel& model() const { return model_; }

  /** What the scans from now on measure.
   *  @param ranges_m one a step from the first to the last; infinite, NaN or at least the maximum
   *  range: nothing there
   *  @throws std::invalid_argument on another number of them */
  void setRanges(std::vector<float> ranges_m);

  enum class Frozen {
    Not,
    Ranges,  ///< the same ranges again and again, with stamps that run on
    Packet   ///< the same bytes again and again, so the same stamp, too
  };
  void freeze(Frozen frozen);

  /** Neither sends nor hears a thing, as with a loose data line or firmware that hangs. */
  void goSilent(bool silent);
  /** A new power-up: forgets all commands, and the clock starts at 0 again. */
  void restart();
  /** Sends only the first bytes of the next scan's packet. */
  void cutNextPacket(std::size_t kept);
  void halveNextPacket();
  /** Damages a share of the bytes of the next scan's ranges, without adding or removing any. */
  void garbleNextPacket(double share);
  /** Sends random bytes before the next scan's packet. */
  void sendGarbage(std::size_t bytes);
  /** The line hangs up and stays so: a driver reads and writes nothing any more. */
  void pullCable();

 private:
  void run();
  void listen(double timeout_s);
  std::string nextPacket();
  void damage(std::string& packet);
  void stop();

  const ScipModel model_;
  PseudoTerminal line_;  // the thread's own, until that has ended

  std::mutex mutex_;  // for all up to the thread
  ScipLaser laser_;
  std::vector<float> ranges_m_, measured_m_;
  std::string input_, lastPacket_;
  Frozen frozen_ = Frozen::Not;
  bool silent_ = false;
  double keptShare_ = 1.0, garbledShare_ = 0.0;
  std::size_t keptBytes_ = 0, garbage_ = 0;
  std::mt19937 dice_;

  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace bslnav::test
