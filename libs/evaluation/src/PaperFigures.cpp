#include <bslnav/evaluation/PaperFigures.h>
#include <bslnav/evaluation/RunDrawing.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>

#include "NumberText.h"
#include "SnapshotRows.h"

namespace bslnav {
namespace {

constexpr int kPageWidth_px = 1800, kGap_px = 20;
constexpr double kWideAspect = 4.0;  // wider worlds are stacked, not put side by side

std::string methodTitle(const NominalRun& run) {
  return "Method " + std::to_string(run.entry.method) + ": " + run.summary.methodName;
}

/** What is worth showing: the walls and a little around them, else all. */
MapBounds inhabitedBounds(const SimulationSetup& setup,
                          const mrpt::maps::COccupancyGridMap2D* map) {
  const MapBounds all = boundsOf(setup, map);
  if (!map) return all;
  constexpr double kMargin_m = 0.3;
  constexpr float kOccupied = 0.45F;  // MRPT cells hold the probability of being free
  MapBounds walls{all.xMax_m, all.yMax_m, all.xMin_m, all.yMin_m};
  for (int row = 0; row < static_cast<int>(map->getSizeY()); ++row)
    for (int column = 0; column < static_cast<int>(map->getSizeX()); ++column) {
      if (map->getCell(column, row) >= kOccupied) continue;
      const double x = map->idx2x(static_cast<std::size_t>(column));
      const double y = map->idx2y(static_cast<std::size_t>(row));
      walls = {std::min(walls.xMin_m, x - kMargin_m), std::min(walls.yMin_m, y - kMargin_m),
               std::max(walls.xMax_m, x + kMargin_m), std::max(walls.yMax_m, y + kMargin_m)};
    }
  return walls.xMin_m < walls.xMax_m && walls.yMin_m < walls.yMax_m ? walls : all;
}

/** The paths that the methods drove, beside each other or, in wide worlds, below each other. */
Picture pathsSection(const std::vector<NominalRun>& runs,
                     const mrpt::maps::COccupancyGridMap2D* map, const MapBounds& bounds) {
  const double aspect = (bounds.xMax_m - bounds.xMin_m) / (bounds.yMax_m - bounds.yMin_m);
  const int columns = runs.size() > 1 && aspect < kWideAspect ? 2 : 1;
  const int width_px = (kPageWidth_px - kGap_px) / columns - kGap_px;
  MapPicture everything("", "", bounds);  // for its legend only
  std::vector<PictureTile> tiles;
  for (const NominalRun& run : runs) {
    MapPicture picture(methodTitle(run), outcomeLine(run.summary), bounds, {width_px, 560, false});
    for (MapPicture* target : {&picture, &everything})
      drawRun(*target, run.entry.setup, map, run.trace, run.summary);
    tiles.push_back({picture.finished(), ""});
  }
  return tiled(tiles, columns,
               "Case " + runs.front().entry.setup.scenario.name +
                   ": the scenario as written, seed " + std::to_string(runs.front().summary.seed),
               everything.legend(kPageWidth_px - 2 * kGap_px));
}

}  // namespace

Picture caseFigure(const std::vector<NominalRun>& runs) {
  const auto map = runs.front().entry.setup.makeMap();
  const MapBounds bounds = inhabitedBounds(runs.front().entry.setup, map.get());
  std::vector<Picture> sections{pathsSection(runs, map.get(), bounds)};
  const SnapshotRows rows(runs, bounds, kPageWidth_px, kGap_px);
  if (!rows.empty()) sections.push_back(rows.finished());
  return stacked(sections);
}

}  // namespace bslnav
