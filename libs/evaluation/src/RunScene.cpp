#include <bslnav/config/Error.h>
#include <bslnav/costmap/DepthFrame.h>
#include <bslnav/costmap/PlanarScan.h>
#include <bslnav/evaluation/PictureStyles.h>
#include <bslnav/evaluation/RunDrawing.h>
#include <bslnav/evaluation/RunScene.h>
#include <bslnav/evaluation/ScenePicture.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/opengl/CGridPlaneXY.h>

#include <algorithm>
#include <utility>

#include "SceneObjects.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPoint3Df;

// Heights above the floor that keep flat things apart.
constexpr double kGrid_m = 0.03, kZone_m = 0.06, kLine_m = 0.1;

void add(mrpt::opengl::COpenGLScene& scene, const scene::Object& object, const std::string& name) {
  object->setName(name);
  scene.insert(object);
}

/** The section of a shape, numbered from the second one of it on. */
std::string nameOf(const WorldShape& shape, std::map<std::string, int>& count) {
  const int n = ++count[shape.section];
  return n == 1 ? shape.section : shape.section + "#" + std::to_string(n);
}

std::vector<TPoint3Df> pointsOf(const mrpt::obs::CObservation2DRangeScan& observation,
                                const mrpt::math::TPose2D& mapFromThen) {
  PlanarScan scan;
  scan.assign(observation, 0.0, mapFromThen);
  const auto x = static_cast<float>(scan.robotFromSensor().x);
  const auto y = static_cast<float>(scan.robotFromSensor().y);
  std::vector<TPoint3Df> points;
  for (std::size_t i = 0; i < scan.beam.size(); ++i)
    if (scan.beam[i] == PlanarScan::Beam::Hit)
      points.emplace_back(x + scan.range_m[i] * scan.cosine[i], y + scan.range_m[i] * scan.sine[i],
                          static_cast<float>(observation.sensorPose.z()));
  return points;
}

}  // namespace

RunScene::RunScene(const SimulationSetup& setup,
                   const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map)
    : setup_(setup), hasMap_(map != nullptr) {
  const MapBounds area = boundsOf(setup, map.get());
  double top_m = 0.5;
  for (const WorldShape& shape : worldShapes(setup.world)) top_m = std::max(top_m, shape.zMax_m);
  const auto f = [](double value) { return static_cast<float>(value); };
  bounds_ = {{f(area.xMin_m), f(area.yMin_m), 0.0f}, {f(area.xMax_m), f(area.yMax_m), f(top_m)}};
}

void RunScene::observe(const SimulationMoment& moment) {
  const double instant_s = setup_.recording.scene_s;
  if (instant_s > 0.0 && moment.record.time_s > instant_s + 1e-6) return;
  startTime_s_ = moment.frame.startTime_s;
  localised_.push_back({moment.record.time_s, moment.record.mapFromRobot});
  truth_.push_back(moment.truth.pose);
  people_ = moment.truth.people;
  path_ = moment.record.path;
  dangerZones_ = moment.record.dangerZones;
  localCosts_ = moment.cycle.surroundings().localCosts();
  costs_ = hasMap_ ? moment.cycle.surroundings().planningCosts() : localCosts_;
  for (const auto& scan : moment.frame.scans) scans_[scan->sensorLabel] = scan;
  for (const auto& depth : moment.frame.depth) depth_[depth->sensorLabel] = depth;
}

mrpt::math::TPose2D RunScene::poseAt(mrpt::Clock::time_point stamp) const {
  return RecordedPath(localised_).poseAt(mrpt::Clock::toDouble(stamp) - startTime_s_);
}

mrpt::opengl::COpenGLScene::Ptr RunScene::make() const {
  auto scene = mrpt::opengl::COpenGLScene::Create();
  auto& view = *scene->getViewport();
  view.setCustomBackgroundColor({1.0f, 1.0f, 1.0f});
  view.getCamera() = cameraFor(
      bounds_, double(setup_.recording.pictureWidth_px) / setup_.recording.pictureHeight_px);
  // Depths between MRPT's 0.1 m and 10 km are too coarse to tell a wall from the floor behind it.
  const float distance_m = view.getCamera().getZoomDistance();
  view.setViewportClipDistances(0.1f * distance_m, 4.0f * distance_m);
  view.lightParameters().ambient = {0.45f, 0.45f, 0.45f};
  view.lightParameters().diffuse = {0.55f, 0.55f, 0.55f};
  view.lightParameters().direction = {-0.25f, 0.35f, -0.903f};  // the floor and the near sides
  addWorld(*scene);
  if (truth_.empty()) return scene;
  addRun(*scene);
  addMeasurements(*scene);
  return scene;
}

void RunScene::addWorld(mrpt::opengl::COpenGLScene& scene) const {
  constexpr double kOpacity = 0.4;  // a wall must not hide what is behind it
  auto floor = mrpt::opengl::CGridPlaneXY::Create(bounds_.min.x, bounds_.max.x, bounds_.min.y,
                                                  bounds_.max.y, static_cast<float>(kGrid_m), 1.0f);
  floor->setColor_u8(palette::kFrame.r, palette::kFrame.g, palette::kFrame.b);
  add(scene, floor, "floor");
  if (costs_.width() > 0)
    add(scene, scene::costMesh(hasMap_ ? scene::merged(costs_, localCosts_) : costs_), "costs");
  std::map<std::string, int> count;
  for (const WorldShape& shape : worldShapes(setup_.world))
    add(scene, scene::solid(shape, shape.mapped ? palette::kFaintInk : palette::kSky, kOpacity),
        nameOf(shape, count));
  std::size_t i = 0;
  for (const auto& [name, person] : setup_.world.pedestrians) {
    const TPoint2D place = i < people_.size() ? people_[i].position : person.path_m.front();
    add(scene, scene::cylinder(place, person.radius_m, 0.0, person.height_m, palette::kMagenta),
        "person:" + name);
    ++i;
  }
}

void RunScene::addRun(mrpt::opengl::COpenGLScene& scene) const {
  std::vector<TPoint2D> driven;
  for (const auto& pose : truth_) driven.emplace_back(pose.x, pose.y);
  add(scene, scene::ribbon(path_, 0.04, kLine_m, palette::kFaintInk), "global path");
  add(scene, scene::ribbon(driven, 0.08, 1.4 * kLine_m, palette::kBlue), "trajectory");
  add(scene, scene::body(truth_.back(), setup_.navigation.footprint, palette::kBlue), "robot");
  const auto& start = setup_.scenario.start;
  const auto& goal = setup_.scenario.goals.back();
  add(scene, scene::disc({start.x, start.y}, 0.2, 0.12, kLine_m, palette::kGreen), "start");
  add(scene, scene::disc({goal.x, goal.y}, 0.3, 0.15, kLine_m, palette::kRed), "goal");
  for (std::size_t i = 0; i < dangerZones_.size(); ++i)
    add(scene,
        scene::disc(dangerZones_[i].centre, dangerZones_[i].radius_m, 0.0, kZone_m,
                    palette::kOrange, 0.35),
        "danger zone " + std::to_string(i + 1));
}

void RunScene::addMeasurements(mrpt::opengl::COpenGLScene& scene) const {
  for (const auto& [label, scan] : scans_)
    add(scene, scene::cloud(pointsOf(*scan, poseAt(scan->timestamp)), palette::kRed, 4.0f),
        "scan:" + label);
  for (const auto& [label, depth] : depth_) {
    DepthFrame frame;
    frame.assign(*depth, poseAt(depth->timestamp));
    add(scene, scene::cloud(frame.points(), palette::kGreen, 2.0f), "depth:" + label);
  }
}

void saveScene(const mrpt::opengl::COpenGLScene& scene, const std::string& file) {
  bool saved = false;
  try {
    saved = scene.saveToFile(file);
  } catch (const std::exception&) {  // its text is MRPT's source line and a backtrace
  }
  if (!saved) throw Error(file, "cannot be written", Error::Kind::Run);
}

}  // namespace bslnav
