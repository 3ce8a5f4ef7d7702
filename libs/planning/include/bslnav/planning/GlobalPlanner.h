#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>
#include <bslnav/planning/AStar.h>
#include <mrpt/math/TPoint2D.h>

#include <optional>
#include <vector>

namespace bslnav {

struct GlobalPlannerParameters {
  double costWeight = 3.0;        ///< a step costs length · (1 + costWeight · cost/252)
  double startTolerance_m = 0.5;  ///< how far a blocked start may be moved
  double goalTolerance_m = 0.5;   ///< how far a blocked or unreachable goal may be moved
  bool allowUnknown = false;      ///< unknown cells are passable, at the highest graded cost

  void describe(ConfigSection& section);
};

/** What a search for a path came to. */
struct PathResult {
  enum class Status { Found, NoPath, StartBlocked, GoalBlocked, StartOutsideMap, GoalOutsideMap };

  Status status = Status::NoPath;
  /** Map frame [m], at least two when found, else none: centres of neighbouring cells from that of
   * the start, or the passable one nearest to it; the last is the goal itself unless moved. */
  std::vector<mrpt::math::TPoint2D> points;
  double cost = 0.0;       ///< weighted length [m] between the first and the last cell
  bool goalMoved = false;  ///< it ends at the nearest reachable cell within the tolerance instead
};

/** The status in words, for reports. */
const char* describe(PathResult::Status status);

/** Finds a cheapest path over a cost grid by A*: eight neighbours, no corner cut.
 *
 * Cells at kInscribedCost and above are blocked; costs are rounded to 1/408 cell a step. Keep the
 * planner: it reuses its buffers. Equal input gives an equal path. */
class GlobalPlanner {
 public:
  explicit GlobalPlanner(const GlobalPlannerParameters& parameters = {})
      : parameters_(parameters), astar_(parameters.costWeight) {}

  /** @param start,goal map frame [m]; not finite counts as outside the map */
  PathResult plan(const CostGrid& grid, const mrpt::math::TPoint2D& start,
                  const mrpt::math::TPoint2D& goal);

 private:
  /** The cell of `p` if it is passable and in a region (0: in any), else the nearest such cell with
   * its centre within `tolerance_m`; cells of a cost up to `roomy` come before all others. */
  std::optional<std::uint32_t> nearest(const CostGrid& grid, const mrpt::math::TPoint2D& p,
                                       double tolerance_m, int region, Cost roomy) const;
  mrpt::math::TPoint2D centre(const CostGrid& grid, std::uint32_t cell) const;

  GlobalPlannerParameters parameters_;
  AStarTerrain terrain_;
  AStar astar_;
};

}  // namespace bslnav
