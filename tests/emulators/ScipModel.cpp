#include "ScipModel.h"

#include <cmath>

namespace bslnav::test {

ScipModel ScipModel::urg04lx() {
  ScipModel model;
  model.name = "URG-04LX";
  model.minRange_mm = 20;
  model.maxRange_mm = 5600;
  model.nothingCode = 0;
  model.tooNearCode = 19;
  model.stepsPerTurn = 1024;
  model.firstStep = 44;
  model.lastStep = 725;
  model.frontStep = 384;
  model.speed_rpm = 600;
  return model;
}

double ScipModel::angle_rad(int step) const {
  return 2.0 * M_PI / stepsPerTurn * (step - frontStep);
}

LaserParameters ScipModel::simulated() const {
  LaserParameters laser;
  laser.yaw_rad = 0.5 * (angle_rad(firstStep) + angle_rad(lastStep));
  laser.fov_rad = angle_rad(lastStep) - angle_rad(firstStep);
  laser.beams = beams();
  laser.minRange_m = 1e-3 * minRange_mm;
  laser.maxRange_m = 1e-3 * maxRange_mm;
  laser.rate_hz = 1.0 / period_s();
  laser.noiseStd_m = laser.dropoutProbability = 0.0;
  return laser;
}

}  // namespace bslnav::test
