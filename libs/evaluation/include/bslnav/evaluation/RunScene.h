#pragma once

#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/navigation/RecordedPath.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace bslnav {

/** Gathers a simulated run, and makes one instant of it a scene for MRPT's SceneViewer3D.
 *
 * Map frame, metres, the floor at z = 0. Objects by name: `floor` (grid), `costs` (the cost map as
 * a coloured mesh), the solids by their section (`wall:left`; further segments `wall:left#2`),
 * `person:NAME`, `robot`, `trajectory`, `global path`, `start`, `goal`, `scan:LABEL`,
 * `depth:LABEL`, `danger zone 1`, ... */
class RunScene {
 public:
  /** @param map null for none; `setup` must outlive this object */
  RunScene(const SimulationSetup& setup,
           const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map);

  /** Takes in one cycle; those after the instant of the scene change nothing. */
  void observe(const SimulationMoment& moment);

  /** The scene, with a camera that sees the whole world. */
  mrpt::opengl::COpenGLScene::Ptr make() const;

 private:
  void addWorld(mrpt::opengl::COpenGLScene& scene) const;
  void addRun(mrpt::opengl::COpenGLScene& scene) const;
  void addMeasurements(mrpt::opengl::COpenGLScene& scene) const;
  mrpt::math::TPose2D poseAt(mrpt::Clock::time_point stamp) const;

  const SimulationSetup& setup_;
  mrpt::math::TBoundingBoxf bounds_;
  bool hasMap_;
  std::vector<RecordedPath::Sample> localised_;
  double startTime_s_ = 0.0;
  std::vector<mrpt::math::TPose2D> truth_;
  std::vector<SimulationState::Person> people_;
  std::vector<mrpt::math::TPoint2D> path_;
  std::vector<DangerZone> dangerZones_;
  CostGrid costs_, localCosts_;
  std::map<std::string, mrpt::obs::CObservation2DRangeScan::ConstPtr> scans_;  // the newest ones
  std::map<std::string, mrpt::obs::CObservation3DRangeScan::ConstPtr> depth_;
};

/** Writes a scene to a file. @throws Error (Run) when it cannot */
void saveScene(const mrpt::opengl::COpenGLScene& scene, const std::string& file);

}  // namespace bslnav
