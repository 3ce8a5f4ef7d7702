#include <bslnav/navigation/MotionHistory.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>

namespace bslnav {

using mrpt::math::TPose2D;

void MotionHistory::add(double time_s, const TPose2D& odometry) {
  samples_[next_] = {time_s, odometry};
  next_ = (next_ + 1) % kSamples;
  count_ = std::min(count_ + 1, kSamples);
}

TPose2D MotionHistory::nowFromThen(double time_s) const {
  if (count_ == 0 || time_s >= sample(0).time_s) return {};
  std::size_t ago = 1;
  while (ago < count_ && sample(ago).time_s > time_s) ++ago;
  const TPose2D& now = sample(0).odometry;
  if (ago == count_) return sample(count_ - 1).odometry - now;
  const Sample &before = sample(ago), &after = sample(ago - 1);
  const double span_s = after.time_s - before.time_s;
  const double f = span_s > 0.0 ? (time_s - before.time_s) / span_s : 1.0;
  const TPose2D &a = before.odometry, &b = after.odometry;
  const double turn = mrpt::math::wrapToPi(b.phi - a.phi);
  return TPose2D(a.x + f * (b.x - a.x), a.y + f * (b.y - a.y), a.phi + f * turn) - now;
}

}  // namespace bslnav
