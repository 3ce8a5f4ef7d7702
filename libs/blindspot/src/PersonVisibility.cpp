#include <bslnav/blindspot/PersonVisibility.h>
#include <bslnav/config/VectorClones.h>

#include <algorithm>
#include <limits>

namespace bslnav {
namespace {

constexpr float kSameThing_m = 0.15f;  // a surface this near to the end of a view ends it

/** Of each pixel in a row: how far along its ray people would be seen, 0 without a depth; and the
 * same where a surface above the floor ends it, else 0.
 *  @param aboveFloor part of leaves_m from which on a ray is near the floor or a head */
BSLNAV_VECTOR_CLONES void measureRow(const float* __restrict depth_m,
                                     const float* __restrict distancePerDepth,
                                     const float* __restrict leaves_m, float aboveFloor, int count,
                                     float* __restrict seen_m, float* __restrict blocked_m) {
  for (int u = 0; u < count; ++u) {
    const float distance = depth_m[u] * distancePerDepth[u], leaves = leaves_m[u];
    seen_m[u] = distance < leaves ? distance : leaves;
    seen_m[u] = depth_m[u] > 0.0f ? seen_m[u] : 0.0f;
    blocked_m[u] = distance < aboveFloor * leaves ? distance : 0.0f;
  }
}

}  // namespace

void PersonVisibilityParameters::describe(ConfigSection& section) {
  section.number("height_m", height_m, {0.3, 3.0}, "m",
                 "height of the smallest person who counts: whoever is smaller may be overlooked "
                 "behind low things");
  section.number("floor_m", floor_m, kNonNegative, "m",
                 "what is lower does not end a view: it is floor, its noise and unevenness");
}

/** A table of what depends on the camera only: where each ray meets the floor or is as high as a
 * person. */
void PersonVisibility::layOut(const DepthFrame& frame) {
  if (!beams_.layOut(frame)) return;
  const auto columns = static_cast<std::size_t>(frame.columns());
  const float below_m = frame.origin().z;
  const float above_m = static_cast<float>(parameters_.height_m) - frame.origin().z;
  leaves_m_.resize(columns * static_cast<std::size_t>(frame.rows()));
  for (auto* values : {&seen_m_, &above_m_, &blocked_m_}) values->resize(columns);
  for (int v = 0; v < frame.rows(); ++v)
    for (std::size_t u = 0; u < columns; ++u) {
      const auto j = static_cast<std::size_t>(v);
      const float slope =
          (frame.columnRays().z[u] + frame.rowRays().z[j]) / beams_.distanceRow(v)[u];
      leaves_m_[j * columns + u] = slope < 0.0f   ? below_m / -slope
                                   : slope > 0.0f ? above_m / slope
                                                  : std::numeric_limits<float>::max();
    }
}

const PlanarScan& PersonVisibility::make(const DepthFrame& frame) {
  layOut(frame);
  beams_.startScan(frame, scan_);
  if (static_cast<double>(frame.origin().z) >= parameters_.height_m) return scan_;
  const auto aboveFloor =
      static_cast<float>(1.0 - parameters_.floor_m / static_cast<double>(frame.origin().z));
  std::fill(above_m_.begin(), above_m_.end(), 0.0f);
  views_.assign(beams_.size(), {0.0f, 0.0f});
  for (int v = 0; v < frame.rows(); ++v) {
    measureRow(
        frame.depthRow(v), beams_.distanceRow(v),
        leaves_m_.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(frame.columns()),
        aboveFloor, frame.columns(), seen_m_.data(), blocked_m_.data());
    takeRow(v);
    above_m_.swap(seen_m_);
  }
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const View& view = views_[i];
    if (view.farthest_m <= 0.0f) continue;
    const bool ends = view.blocked_m > 0.0f && view.blocked_m + kSameThing_m >= view.farthest_m;
    scan_.setBeam(i, ends ? PlanarScan::Beam::Hit : PlanarScan::Beam::NoReturn, view.farthest_m);
  }
  return scan_;
}

void PersonVisibility::takeRow(int v) {
  const std::uint16_t* beams = beams_.beamRow(v);
  for (std::size_t u = 0; u < seen_m_.size(); ++u) {
    View& view = views_[beams[u]];
    view.farthest_m = std::max(view.farthest_m, std::min(seen_m_[u], above_m_[u]));
    view.blocked_m = std::max(view.blocked_m, std::min(blocked_m_[u], above_m_[u]));
  }
}

}  // namespace bslnav
