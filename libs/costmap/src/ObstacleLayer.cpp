#include <bslnav/costmap/ObstacleLayer.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bslnav {
namespace {

constexpr int kShift = 32;  // fractional bits of fixed point
constexpr double kOne = 4294967296.0;
constexpr double kTopUnit_m = 0.02;
constexpr std::uint8_t kAnyTop = 255;  // seen wherever the camera looks

/** A height in whole units, rounded down: what was marked reached at least there. */
std::uint8_t topOf(const PlanarScan& scan, std::size_t beam) {
  return scan.top_m.empty() ? std::uint8_t{0}
                            : static_cast<std::uint8_t>(std::clamp(
                                  static_cast<double>(scan.top_m[beam]) / kTopUnit_m, 0.0, 255.0));
}

/** Whether a cell or one of its eight neighbours is lethal: a laser and a camera meet the same
 * thing a cell apart. */
bool isMarked(const CostGrid& grid, int x, int y) {
  const CellWindow near = CellWindow{x - 1, y - 1, x + 2, y + 2}.intersected(grid.bounds());
  for (int row = near.y0; row < near.y1; ++row)
    for (int column = near.x0; column < near.x1; ++column)
      if (grid.at(column, row) == kLethalCost) return true;
  return false;
}

/** std::floor without the library call that it needs on SSE2. */
int floorToCell(double value) {
  const int truncated = static_cast<int>(value);
  return truncated - (value < truncated ? 1 : 0);
}

/** Likewise. */
std::int64_t toFixed(double cells) {
  const double value = cells * kOne;
  const auto truncated = static_cast<std::int64_t>(value);
  return truncated - (value < static_cast<double>(truncated) ? 1 : 0);
}

}  // namespace

void ObstacleParameters::describe(ConfigSection& section) {
  section.number("obstacle_range_m", obstacleRange_m, kPositive, "m",
                 "returns farther away make no mark");
  section.number("raytrace_range_m", raytraceRange_m, kPositive, "m",
                 "beams clear marks up to this distance");
  section.flag("clear_no_return", clearNoReturn,
               "whether a beam without return clears up to raytrace_range_m");
  section.flag("clear_footprint", clearFootprint, "whether marks under the robot are cleared");
}

inline ObstacleLayer::Line::Line(const Point& from, const Point& to)
    : alongX(std::abs(to.x - from.x) >= std::abs(to.y - from.y)) {
  const double major0 = alongX ? from.x : from.y, minor0 = alongX ? from.y : from.x;
  const double major1 = alongX ? to.x : to.y, minor1 = alongX ? to.y : to.x;
  first = floorToCell(major0);
  const int last = floorToCell(major1);
  step = last >= first ? 1 : -1;
  count = std::abs(last - first);
  const double gradient = count > 0 ? (minor1 - minor0) / (major1 - major0) : 0.0;
  row = toFixed(minor0 + (first + 0.5 - major0) * gradient);
  slope = toFixed(gradient * step);
}

inline void ObstacleLayer::Line::skip(int cells) {
  first += cells * step;
  row += cells * slope;
  count -= cells;
}

/** Drops what lies outside [0, majorSize) × [0, minorSize); what is left is one piece, since a line
 * is straight. */
inline void ObstacleLayer::Line::clip(int majorSize, int minorSize) {
  const std::int64_t limit = static_cast<std::int64_t>(minorSize) << kShift;
  while (count > 0 && (first < 0 || first >= majorSize || row < 0 || row >= limit)) skip(1);
  count = std::min(count, step > 0 ? majorSize - first : first + 1);
  const std::int64_t last = row + slope * (count - 1);
  if (count <= 0 || (last >= 0 && last < limit)) return;
  count = static_cast<int>((slope > 0 ? (limit - 1 - row) / slope : row / -slope) + 1);
}

/** How many cells from the start on are also cells of `a` or `b`, lines from the same point on both
 * sides of this one: as long as their rows differ by less than 1, there is no third row between. */
inline int ObstacleLayer::Line::sharedWith(const Line& a, const Line& b) const {
  const bool between =
      (a.slope <= slope && slope <= b.slope) || (b.slope <= slope && slope <= a.slope);
  const auto alike = [this](const Line& o) {
    return o.alongX == alongX && o.step == step && o.first == first;
  };
  if (!between || !alike(a) || !alike(b)) return 0;
  const auto room = static_cast<double>((std::int64_t{1} << kShift) - std::abs(a.row - b.row));
  const auto spread = static_cast<double>(std::abs(a.slope - b.slope));
  const int most = std::min({count, a.count, b.count});
  if (room >= spread * most) return most;
  return std::max(0, static_cast<int>(room / spread));
}

inline ObstacleLayer::Line ObstacleLayer::lineWithin(const Point& from, const Point& to) const {
  Line line(from, to);
  line.clip(line.alongX ? grid_.width() : grid_.height(),
            line.alongX ? grid_.height() : grid_.width());
  return line;
}

inline void ObstacleLayer::clear(const Line& line) {
  const std::ptrdiff_t stride = grid_.width();
  Cost* const cells = grid_.row(0);
  std::int64_t row = line.row;
  if (line.alongX) {
    Cost* column = cells + line.first;
    for (int i = 0; i < line.count; ++i, column += line.step, row += line.slope)
      column[(row >> kShift) * stride] = kFreeCost;
  } else {
    Cost* start = cells + line.first * stride;
    for (int i = 0; i < line.count; ++i, start += line.step * stride, row += line.slope)
      start[row >> kShift] = kFreeCost;
  }
}

ObstacleLayer::ObstacleLayer(const ObstacleParameters& parameters, const Footprint& footprint,
                             const CostGrid& shape)
    : parameters_(parameters), footprint_(footprint), grid_(shape) {
  grid_.fill(kUnknownCost);
}

CellWindow ObstacleLayer::update(const mrpt::math::TPose2D& mapFromRobot,
                                 const std::vector<PlanarScan>& scans, const CostGrid* lasers) {
  CellWindow visited;
  marks_.clear();
  for (const auto& scan : scans) {
    visited = visited.united(trace(mapFromRobot, scan));
    clearAlongLines(scan.start_m.empty());
    if (!scan.start_m.empty()) clearBelowView(mapFromRobot, scan);
  }
  for (const Mark& mark : marks_) grid_.at(mark.x, mark.y) = kLethalCost;
  if (tops_.width() > 0)
    for (const Mark& mark : marks_)
      tops_.at(mark.x, mark.y) = lasers && isMarked(*lasers, mark.x, mark.y) ? kAnyTop : mark.top;
  if (parameters_.clearFootprint) visited = visited.united(clearUnder(mapFromRobot));
  return visited.intersected(grid_.bounds());
}

void ObstacleLayer::shift(int dx, int dy) {
  grid_.shift(dx, dy, kUnknownCost);
  if (tops_.width() > 0) tops_.shift(dx, dy, 0);
}

/** Fills lines_ and appends to marks_; returns the window of both. */
CellWindow ObstacleLayer::trace(const mrpt::math::TPose2D& mapFromRobot, const PlanarScan& scan) {
  const double perCell = 1.0 / grid_.getResolution();
  const double c = std::cos(mapFromRobot.phi) * perCell, s = std::sin(mapFromRobot.phi) * perCell;
  const auto& sensor = scan.robotFromSensor();
  const Point from{(mapFromRobot.x - grid_.getXMin()) * perCell + c * sensor.x - s * sensor.y,
                   (mapFromRobot.y - grid_.getYMin()) * perCell + s * sensor.x + c * sensor.y};
  const CellWindow bounds = grid_.bounds();
  double left = from.x, right = from.x, bottom = from.y, top = from.y;
  lines_.assign(scan.beam.size(), Line());
  for (std::size_t i = 0; i < scan.beam.size(); ++i) {
    if (scan.beam[i] == PlanarScan::Beam::Dropped) continue;
    const bool hit = scan.beam[i] == PlanarScan::Beam::Hit;
    const bool seesFloor = !scan.start_m.empty();
    if (!hit && !seesFloor && !parameters_.clearNoReturn) continue;
    const double range_m = scan.range_m[i];
    const double dx = c * scan.cosine[i] - s * scan.sine[i],
                 dy = s * scan.cosine[i] + c * scan.sine[i];
    const bool known = hit || seesFloor;  // else the beam is taken for free all the way
    const double cleared_m =
        std::min(known ? range_m : parameters_.raytraceRange_m, parameters_.raytraceRange_m);
    const double start_m = seesFloor ? std::min<double>(scan.start_m[i], cleared_m) : 0.0;
    const Point to{from.x + cleared_m * dx, from.y + cleared_m * dy};
    lines_[i] = lineWithin({from.x + start_m * dx, from.y + start_m * dy}, to);
    left = std::min(left, to.x), right = std::max(right, to.x);
    bottom = std::min(bottom, to.y), top = std::max(top, to.y);
    if (!hit || range_m > parameters_.obstacleRange_m) continue;
    const int x = floorToCell(from.x + range_m * dx), y = floorToCell(from.y + range_m * dy);
    if (bounds.contains(x, y)) marks_.push_back({x, y, topOf(scan, i)});
  }
  return {floorToCell(left) - 1, floorToCell(bottom) - 1, floorToCell(right) + 2,
          floorToCell(top) + 2};
}

/** Marks nearer than the floor is seen: gone is only what the camera would still see. */
void ObstacleLayer::clearBelowView(const mrpt::math::TPose2D& mapFromRobot,
                                   const PlanarScan& scan) {
  if (tops_.width() == 0) {
    tops_ = grid_;
    tops_.fill(0);
  }
  if (scan.size() < 2) return;
  const auto sensor = mapFromRobot + scan.robotFromSensor();
  double reach_m = 0.0;
  for (const float start_m : scan.start_m)
    reach_m = std::max(reach_m, std::min<double>(start_m, parameters_.raytraceRange_m));
  const CellWindow around =
      CellWindow{grid_.cellX(sensor.x - reach_m), grid_.cellY(sensor.y - reach_m),
                 grid_.cellX(sensor.x + reach_m) + 1, grid_.cellY(sensor.y + reach_m) + 1}
          .intersected(grid_.bounds());
  const double first = std::atan2(scan.sine[0], scan.cosine[0]) + mapFromRobot.phi;
  const double step = std::asin(static_cast<double>(scan.cosine[0] * scan.sine[1]) -
                                static_cast<double>(scan.sine[0] * scan.cosine[1]));
  for (int y = around.y0; y < around.y1; ++y)
    for (int x = around.x0; x < around.x1; ++x) {
      if (grid_.at(x, y) != kLethalCost) continue;
      const double dx = grid_.idx2x(x) - sensor.x, dy = grid_.idx2y(y) - sensor.y;
      const double angle = mrpt::math::wrapTo2Pi(std::atan2(dy, dx) - first + 0.5 * step);
      const auto beam = static_cast<std::size_t>(angle / step);
      if (beam >= scan.beam.size() || scan.beam[beam] == PlanarScan::Beam::Dropped) continue;
      const double range_m = std::hypot(dx, dy);
      const double start_m = scan.start_m[beam];
      const double lowestSeen_m = scan.sensorHeight_m * (1.0 - range_m / start_m);
      const bool sees = tops_.at(x, y) * kTopUnit_m > lowestSeen_m + kTopUnit_m;
      if (sees && range_m < std::min(start_m, parameters_.raytraceRange_m) &&
          range_m + grid_.getResolution() < scan.range_m[beam])
        grid_.at(x, y) = kFreeCost;
    }
}

/** Near the sensor many beams visit the same cells. As in a binary tree, each beam leaves out what
 * the two do that are as far away from it as its index has factors of two. */
void ObstacleLayer::clearAlongLines(bool fromOnePoint) {
  const std::size_t count = lines_.size();
  for (std::size_t i = 0; i < count; ++i) {
    Line line = lines_[i];
    const std::size_t distance = i & (~i + 1);
    if (fromOnePoint && i > 0 && i + distance < count)
      line.skip(line.sharedWith(lines_[i - distance], lines_[i + distance]));
    clear(line);
  }
}

CellWindow ObstacleLayer::clearUnder(const mrpt::math::TPose2D& mapFromRobot) {
  const double reach_m = footprint_.circumscribedRadius_m();
  const CellWindow around =
      CellWindow{grid_.cellX(mapFromRobot.x - reach_m), grid_.cellY(mapFromRobot.y - reach_m),
                 grid_.cellX(mapFromRobot.x + reach_m) + 1,
                 grid_.cellY(mapFromRobot.y + reach_m) + 1}
          .intersected(grid_.bounds());
  const double c = std::cos(mapFromRobot.phi), s = std::sin(mapFromRobot.phi);
  for (int y = around.y0; y < around.y1; ++y)
    for (int x = around.x0; x < around.x1; ++x) {
      const double dx = grid_.idx2x(x) - mapFromRobot.x, dy = grid_.idx2y(y) - mapFromRobot.y;
      if (footprint_.contains({c * dx + s * dy, c * dy - s * dx})) grid_.at(x, y) = kFreeCost;
    }
  return around;
}

}  // namespace bslnav
