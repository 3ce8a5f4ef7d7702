#include <bslnav/blindspot/ScanJumpDetector.h>

#include <cmath>

namespace bslnav {
namespace {

constexpr int kNone = -1;

/** Angle from beam i to beam j, counterclockwise, in [−π, π]. */
double angleBetween(const PlanarScan& scan, std::size_t i, std::size_t j) {
  const double ci = scan.cosine[i], si = scan.sine[i], cj = scan.cosine[j], sj = scan.sine[j];
  return std::atan2(ci * sj - si * cj, ci * cj + si * sj);
}

/** Whether the first beam follows the last as closely as beams follow each other. */
bool isFullCircle(const PlanarScan& scan) {
  if (scan.size() < 2) return false;
  const double step = std::abs(angleBetween(scan, 0, 1));
  return std::abs(angleBetween(scan, static_cast<std::size_t>(scan.size() - 1), 0)) < 1.5 * step;
}

BlindSpot blindSpotAt(const PlanarScan& scan, std::size_t i) {
  const double range = scan.range_m[i];
  const auto& sensor = scan.robotFromSensor();
  return BlindSpot::at({sensor.x + range * scan.cosine[i], sensor.y + range * scan.sine[i]});
}

}  // namespace

void ScanJumpParameters::describe(ConfigSection& section) {
  section.number("threshold_m", threshold_m, kPositive, "m",
                 "range difference of neighbouring beams that makes a blind spot");
  section.choice("no_return", noReturn,
                 {{"max_range", NoReturn::MaxRange}, {"skip", NoReturn::Skip}},
                 "a beam without return sees up to the maximum range, or says nothing");
}

const std::vector<BlindSpot>& ScanJumpDetector::detect(const std::vector<PlanarScan>& scans) {
  blindSpots_.clear();
  for (const auto& scan : scans) detectIn(scan);
  return blindSpots_;
}

void ScanJumpDetector::detectIn(const PlanarScan& scan) {
  using Beam = PlanarScan::Beam;
  const int size = scan.size();
  // A circle goes on past its seam, up to the first beam that says something.
  const int end = isFullCircle(scan) ? 2 * size : size;
  int previous = kNone;                 // beam to compare with
  int first = kNone, boundary = kNone;  // beams found first and last
  for (int k = 0; k < end; ++k) {
    const int i = k % size;
    const auto current = static_cast<std::size_t>(i);
    const bool skipped =
        scan.beam[current] == Beam::NoReturn && parameters_.noReturn == NoReturn::Skip;
    if (scan.beam[current] == Beam::Dropped) continue;
    if (previous != kNone && !skipped) {
      const float before = scan.range_m[static_cast<std::size_t>(previous)];
      const float here = scan.range_m[current];
      const int nearer = here < before ? i : previous;
      const bool jump = std::abs(here - before) > parameters_.threshold_m;
      if (jump && nearer != boundary && nearer != first) {
        blindSpots_.push_back(blindSpotAt(scan, static_cast<std::size_t>(nearer)));
        boundary = nearer;
        if (first == kNone) first = nearer;
      }
    }
    if (k >= size) break;
    previous = skipped ? kNone : i;
  }
}

}  // namespace bslnav
