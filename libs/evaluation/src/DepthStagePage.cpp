#include <bslnav/evaluation/DepthStagePage.h>
#include <bslnav/evaluation/PictureStyles.h>
#include <bslnav/pictures/MapPicture.h>
#include <bslnav/pictures/PictureTiles.h>

#include <algorithm>
#include <cstdio>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3Df;

constexpr int kWidth_px = 600, kHeight_px = 520;
constexpr float kTop_m = 2.0f;  // of the height scale
constexpr Colour kClusterColours[] = {palette::kBlue,    palette::kGreen, palette::kRed,
                                      palette::kMagenta, palette::kSky,   palette::kOrange};

Colour heightColour(float z) {
  return colourAt(ColourMap::Speed, static_cast<double>(std::clamp(z / kTop_m, 0.0f, 1.0f)));
}

std::string caption(const char* format, std::size_t count) {
  char text[96];
  std::snprintf(text, sizeof text, format, count);
  return text;
}

/** The robot frame from above, as far as the points reach. */
MapBounds boundsOf(const PointCloud& points) {
  MapBounds bounds{-0.6, -1.5, 2.0, 1.5};
  for (const auto& p : points) {
    const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
    bounds.xMax_m = std::max(bounds.xMax_m, x + 0.6);
    bounds.yMin_m = std::min(bounds.yMin_m, y - 0.3);
    bounds.yMax_m = std::max(bounds.yMax_m, y + 0.3);
  }
  return bounds;
}

/** Draws one tile after the other, all of the same part of the robot frame. */
class Tiles {
 public:
  Tiles(const MapBounds& bounds, const Footprint& footprint)
      : bounds_(bounds), footprint_(footprint) {}

  template <typename Draw>
  void add(const std::string& text, Draw&& draw) {
    MapPicture picture("", "", bounds_, {kWidth_px, kHeight_px, false});
    draw(picture);
    picture.outline({0.0, 0.0, 0.0}, footprint_, style::kRobot, "robot");
    tiles.push_back({picture.finished(), text});
  }
  std::vector<PictureTile> tiles;

 private:
  MapBounds bounds_;
  Footprint footprint_;
};

template <typename ColourOf>
void drawPoints(MapPicture& picture, const PointCloud& points, double radius_m,
                ColourOf&& colourOf) {
  constexpr std::size_t kMost = 40000;
  const std::size_t stride = 1 + points.size() / kMost;
  for (std::size_t i = 0; i < points.size(); i += stride)
    picture.disc({static_cast<double>(points[i].x), static_cast<double>(points[i].y)}, radius_m,
                 {colourOf(i), 1.0, 0.0}, "");
}

void drawHeights(MapPicture& picture, const PointCloud& points, double radius_m) {
  drawPoints(picture, points, radius_m, [&](std::size_t i) { return heightColour(points[i].z); });
}

Colour clusterColour(int cluster) {
  constexpr int kCount = static_cast<int>(std::size(kClusterColours));
  return cluster < 0 ? palette::kRejected : kClusterColours[cluster % kCount];
}

void drawClusters(MapPicture& picture, const ClusteredCloud& cloud, double radius_m) {
  drawPoints(picture, cloud.points, radius_m,
             [&](std::size_t i) { return clusterColour(cloud.cluster[i]); });
}

/** The nearest clusters' boxes and where they end. */
void drawBoundaries(MapPicture& picture, const DepthStages& stages) {
  for (const int nearest : {stages.left, stages.right}) {
    if (nearest < 0) continue;
    const DepthCluster& c = stages.clusters[static_cast<std::size_t>(nearest)];
    const double x0 = c.lower.x, x1 = c.upper.x, y0 = c.lower.y, y1 = c.upper.y;
    picture.polyline({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}},
                     {palette::kInk, 2.0, false}, "box of a nearest cluster");
    const auto end = c.boundary().position;
    picture.marker(MarkerKind::BlindSpot, end, "blind spot boundary");
  }
}

/** Keys of the colours, for below all tiles. */
Picture legendOf(const MapBounds& bounds) {
  MapPicture picture("", "", bounds, {kWidth_px, kHeight_px, false});
  for (const float z : {0.0f, 0.5f, 1.0f, 1.5f, 2.0f}) {
    char text[32];
    std::snprintf(text, sizeof text, z < kTop_m ? "height %.1f m" : "%.1f m and above",
                  static_cast<double>(z));
    picture.disc({0.0, 0.0}, 0.05, {heightColour(z), 1.0, 0.0}, text);
  }
  picture.disc({0.0, 0.0}, 0.05, {palette::kRejected, 1.0, 0.0}, "cluster too small");
  picture.polyline({{0.0, 0.0}, {0.1, 0.0}}, {palette::kInk, 2.0, false},
                   "box of a nearest cluster");
  picture.marker(MarkerKind::BlindSpot, {0.0, 0.0}, "blind spot boundary");
  picture.disc({0.0, 0.0}, 0.05, style::kDangerZone, "danger zone");
  picture.outline({0.0, 0.0, 0.0}, Footprint{}, style::kRobot, "robot");
  return picture.legend(3 * kWidth_px);
}

PictureTile costTile(const CycleRecord& record, const CostGrid& costs, const Footprint& footprint,
                     const MapBounds& robotBounds) {
  const auto& pose = record.mapFromRobot;
  MapBounds bounds{pose.x, pose.y, pose.x, pose.y};
  for (const double x : {robotBounds.xMin_m, robotBounds.xMax_m})
    for (const double y : {robotBounds.yMin_m, robotBounds.yMax_m}) {
      const TPoint2D p = pose.composePoint({x, y});
      bounds = {std::min(bounds.xMin_m, p.x), std::min(bounds.yMin_m, p.y),
                std::max(bounds.xMax_m, p.x), std::max(bounds.yMax_m, p.y)};
    }
  MapPicture picture("", "", bounds, {kWidth_px, kHeight_px, false});
  picture.costs(costs);
  for (const auto& zone : record.dangerZones)
    picture.disc(zone.centre, zone.radius_m, style::kDangerZone, "danger zone");
  picture.outline(pose, footprint, style::kRobot, "robot");
  return {picture.finished(), "6  cost map with danger zones (map frame)"};
}

}  // namespace

DepthStagePage::DepthStagePage(const CycleRecord& record, const NavigationCycle& cycle,
                               const NavigationParameters& parameters)
    : stages_(depthStages(cycle.surroundings().depthFrames(), parameters.depthClusters)) {
  const ClusteredCloud& kept = stages_.clustered;
  const double half_m = 0.5 * parameters.depthClusters.leaf_m;
  const MapBounds bounds = boundsOf(stages_.voxels);
  Tiles tiles(bounds, parameters.footprint);
  tiles.add(caption("1  depth camera's cloud: %zu points", stages_.points.size()),
            [&](MapPicture& p) { drawHeights(p, stages_.points, 0.4 * half_m); });
  tiles.add(caption("2  voxels: %zu", stages_.voxels.size()),
            [&](MapPicture& p) { drawHeights(p, stages_.voxels, half_m); });
  tiles.add(caption("3  without ground and ceiling: %zu", kept.points.size()),
            [&](MapPicture& p) { drawHeights(p, kept.points, half_m); });
  tiles.add(caption("4  clusters: %zu", stages_.clusters.size()),
            [&](MapPicture& p) { drawClusters(p, kept, half_m); });
  tiles.add("5  where the nearest left and right one end", [&](MapPicture& p) {
    drawClusters(p, kept, half_m);
    drawBoundaries(p, stages_);
    for (const auto& zone : record.dangerZones)
      p.disc(record.mapFromRobot.inverseComposePoint(zone.centre), zone.radius_m,
             style::kDangerZone, "danger zone");
  });
  tiles.tiles.push_back(
      costTile(record, cycle.surroundings().localCosts(), parameters.footprint, bounds));
  char title[96];
  std::snprintf(title, sizeof title,
                "From depth to danger zones, t = %.1f s, %.2f m/s (robot frame)", record.time_s,
                speedOf(record.twist));
  page_ = tiled(tiles.tiles, 3, title, legendOf(bounds));
}

std::string DepthStagePage::save(const std::string& directory, const std::string& name,
                                 CloudFormat format) const {
  const std::string stem = directory + "/" + name;
  page_.save(stem + ".png");
  if (format != CloudFormat::None) {
    saveCloud(stem + "-points", format, stages_.points);
    saveCloud(stem + "-voxels", format, stages_.voxels);
    saveCloud(stem + "-clusters", format, stages_.clustered.points, stages_.clustered.cluster);
  }
  return stem + ".png";
}

}  // namespace bslnav
