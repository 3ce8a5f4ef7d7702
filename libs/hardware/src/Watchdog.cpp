#include <bslnav/hardware/Watchdog.h>

#include <chrono>
#include <utility>

namespace bslnav {
namespace {

constexpr auto kLook = std::chrono::milliseconds(20);
constexpr std::array<const char*, 3> kNames{"the control loop", "a sensor", "the pose"};

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Watchdog::Watchdog(Base& base, const Limits& limits)
    : base_(base), limits_s_{limits.loop_s, limits.sensors_s, limits.pose_s} {
  heard_s_.fill(now_s());
  thread_ = std::thread([this] { watch(); });
}

Watchdog::~Watchdog() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  endingChanged_.notify_all();
  thread_.join();
}

void Watchdog::heard(Source source) {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_s_[static_cast<std::size_t>(source)] = now_s();
}

std::string Watchdog::tripped() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(tripped_, {});
}

int Watchdog::trips() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return trips_;
}

bool Watchdog::isLate(std::string* who) const {
  for (std::size_t i = 0; i < heard_s_.size(); ++i) {
    if (now_s() - heard_s_[i] <= limits_s_[i]) continue;
    *who = kNames[i];
    return true;
  }
  return false;
}

/** As long as somebody is late the base is told to stop again and again: a command may have come
 * between. */
void Watchdog::watch() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!endingChanged_.wait_for(lock, kLook, [this] { return ending_; })) {
    std::string who;
    const bool late = isLate(&who);
    if (late && !late_) {
      ++trips_;
      tripped_ = who;
    }
    late_ = late;
    if (!late) continue;
    lock.unlock();  // a base may take its time
    base_.stop();
    lock.lock();
  }
}

}  // namespace bslnav
