#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/Footprint.h>
#include <bslnav/pictures/Picture.h>
#include <bslnav/pictures/PictureStyle.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <memory>
#include <string>
#include <vector>

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace bslnav {

/** The part of the map frame that a picture shows, in metres. */
struct MapBounds {
  double xMin_m = 0.0, yMin_m = 0.0, xMax_m = 0.0, yMax_m = 0.0;
};

struct MapPictureOptions {
  int maxWidth_px = 1400;      ///< of the page
  int maxDataHeight_px = 900;  ///< of the map in it
  bool legend = true;          ///< false for tiles, which need only one of them
  bool axes = true;            ///< false for small tiles: no ticks and no margins, only the grid
};

/** One rollout of a planner. */
struct CandidateLine {
  std::vector<mrpt::math::TPoint2D> points;  ///< map frame [m]
  double cost = 0.0;                         ///< total; not finite counts as rejected
  bool rejected = false;
};

/** A picture of a map for reports: axes in metres, equal aspect, legend and colour bars made from
 * what was drawn.
 *
 * Everything is in the map frame in metres; later calls draw over earlier ones. The page follows
 * the aspect of the bounds; the legend stands below wide maps and beside others. A label is a
 * legend entry, "" draws without one. Texts are ASCII. Points that are not finite are left out. */
class MapPicture {
 public:
  /** @throws Error (Run) when the bounds are empty or not finite */
  MapPicture(const std::string& title, const std::string& subtitle, const MapBounds& bounds,
             const MapPictureOptions& options = {});
  ~MapPicture();
  MapPicture(MapPicture&&) noexcept;
  MapPicture& operator=(MapPicture&&) noexcept;

  /** Walls dark, free white, unknown (also off the map) light grey. */
  void occupancy(const mrpt::maps::COccupancyGridMap2D& map);
  /** Graded costs by colour, inscribed, lethal and unknown in their own; free cells and the outside
   * of the grid stay. */
  void costs(const CostGrid& grid);

  /** A driven path coloured by speed. @throws Error (Run) unless there is one speed [m/s] for each
   * point */
  void trajectory(const std::vector<mrpt::math::TPoint2D>& points,
                  const std::vector<double>& speeds_mps, double maxSpeed_mps,
                  const std::string& label);
  void polyline(const std::vector<mrpt::math::TPoint2D>& points, const LineStyle& style,
                const std::string& label);
  void segment(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b, const LineStyle& style,
               const std::string& label);
  /** Rejected ones grey, the others by total cost over them, the cheapest on top; `label` names the
   * colour bar. */
  void candidates(const std::vector<CandidateLine>& lines, const std::string& label);

  void disc(const mrpt::math::TPoint2D& centre, double radius_m, const FillStyle& style,
            const std::string& label);
  void polygon(const std::vector<mrpt::math::TPoint2D>& corners, const FillStyle& style,
               const std::string& label);
  /** A robot's outline with a line from its centre forward. */
  void outline(const mrpt::math::TPose2D& mapFromRobot, const Footprint& footprint,
               const FillStyle& style, const std::string& label);
  void marker(MarkerKind kind, const mrpt::math::TPoint2D& at, const std::string& label);
  /** A short text beside a point. */
  void note(const mrpt::math::TPoint2D& at, const std::string& text);

  /** Where a point of the map lies in the finished picture: columns from the left, rows from the
   * top. */
  mrpt::math::TPoint2D pixelOf(const mrpt::math::TPoint2D& p) const;
  Picture finished() const;
  /** The legend alone, at most this wide, for pages that show several pictures. */
  Picture legend(int width_px) const;
  /** Writes a PNG. @throws Error (Run) when it cannot */
  void save(const std::string& path) const { finished().save(path); }

 private:
  struct Page;
  std::unique_ptr<Page> page_;
};

}  // namespace bslnav
