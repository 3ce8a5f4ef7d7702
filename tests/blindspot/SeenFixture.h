#pragma once

#include <bslnav/blindspot/SeenPeople.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ScanFixture.h"

namespace bslnav::test {

inline constexpr double kWalk_mps = 1.2;

/** 180 beams ahead, no return but for a disc at (x, y). */
inline PlanarScan discAt(double x, double y, double radius) {
  std::vector<float> ranges;
  constexpr int kBeams = 361;
  for (int i = 0; i < kBeams; ++i) {
    const double a = -M_PI / 2.0 + M_PI * i / (kBeams - 1);
    const double along = x * std::cos(a) + y * std::sin(a),
                 across = y * std::cos(a) - x * std::sin(a);
    const bool hit = along > 0.0 && std::abs(across) < radius;
    ranges.push_back(hit ? static_cast<float>(along - std::sqrt(radius * radius - across * across))
                         : kNone);
  }
  return scanOf(ranges);
}

inline CostGrid freeMap() { return CostGrid(160, 160, 0.05, -4.0, -4.0, 0); }

/** SeenPeople in a place whose map is this. */
class Seen {
 public:
  explicit Seen(const CostGrid& mapped = freeMap(), const CostGrid& walls = freeMap())
      : mapped_(mapped), walls_(walls), reached_(mapped.width(), mapped.height()) {
    standing_.follow(mapped);
    reached_.invert();  // from anywhere
  }

  /** Somebody unseen can have got to this place only. */
  void reachedOnlyAt(double x_m, double y_m) {
    reached_.clear();
    reached_.set(mapped_.cellX(x_m), mapped_.cellY(y_m));
  }

  /** There is a side to which no sensor looks. */
  void haveBlindSide() { hasBlindSide_ = true; }

  void update(const SeenPeople::Views& views, double stamp_s) {
    people_.update(views, stamp_s, {}, {mapped_, walls_, standing_, reached_, hasBlindSide_},
                   kWalk_mps);
  }
  const Frontier& frontier() const { return people_.frontier(); }
  const Movers& movers() const { return people_.movers(); }
  const std::vector<mrpt::math::TPoint2D>& bodies() const { return people_.bodies(); }
  const std::vector<Track>& tracks() const { return people_.tracks(); }

 private:
  CostGrid mapped_, walls_;
  StandingThings standing_;
  BitGrid reached_;
  bool hasBlindSide_ = false;
  SeenPeople people_{SeenPeopleParameters{}};
};

/** A scan that sees the nearer of two things. */
inline PlanarScan nearerOf(const PlanarScan& a, const PlanarScan& b) {
  std::vector<float> ranges;
  for (std::size_t k = 0; k < a.beam.size(); ++k) {
    const float inA = a.beam[k] == PlanarScan::Beam::Hit ? a.range_m[k] : 1e3f;
    const float inB = b.beam[k] == PlanarScan::Beam::Hit ? b.range_m[k] : 1e3f;
    ranges.push_back(inA < 1e3f || inB < 1e3f ? std::min(inA, inB) : kNone);
  }
  return scanOf(ranges);
}

}  // namespace bslnav::test
