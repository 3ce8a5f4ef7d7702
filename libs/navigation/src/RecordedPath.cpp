#include <bslnav/config/Error.h>
#include <bslnav/navigation/Localization.h>
#include <bslnav/navigation/RawlogReader.h>
#include <bslnav/navigation/RecordedPath.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bslnav {

using mrpt::math::TPose2D;

RecordedPath::RecordedPath(std::vector<Sample> samples) : samples_(std::move(samples)) {
  if (samples_.empty()) throw Error("recorded path", "is empty; expected a pose", Error::Kind::Run);
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const Sample &from = samples_[i - 1], &to = samples_[i];
    if (!(to.time_s >= from.time_s))
      throw Error("recorded path, pose " + std::to_string(i),
                  "time goes back; expected ascending times", Error::Kind::Run);
    length_m_ += std::hypot(to.pose.x - from.pose.x, to.pose.y - from.pose.y);
  }
}

TPose2D RecordedPath::poseAt(double time_s) const {
  const auto after =
      std::upper_bound(samples_.begin(), samples_.end(), time_s,
                       [](double t, const Sample& sample) { return t < sample.time_s; });
  if (after == samples_.begin()) return samples_.front().pose;
  if (after == samples_.end()) return samples_.back().pose;
  const Sample& before = *std::prev(after);
  const double part = (time_s - before.time_s) / (after->time_s - before.time_s);
  const TPose2D &a = before.pose, &b = after->pose;
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
          mrpt::math::wrapToPi(a.phi + part * mrpt::math::wrapToPi(b.phi - a.phi))};
}

RecordedPath recordPath(RawlogReader& log, Localization& localization) {
  std::vector<RecordedPath::Sample> samples;
  for (SensorFrame frame; log.next(frame);)
    samples.push_back({frame.time_s, localization.update(frame), localization.spread_m()});
  return RecordedPath(std::move(samples));
}

}  // namespace bslnav
