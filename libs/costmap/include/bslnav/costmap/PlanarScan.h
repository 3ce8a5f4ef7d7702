#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** A horizontal scan made ready for the control cycle: checked ranges and directions in the robot
 * frame.
 *
 * Beams run counterclockwise. Built once a cycle from MRPT's observation, or from a depth image
 * (DepthScan); assigning to the same object again does not allocate.
 */
class PlanarScan {
 public:
  enum class Beam : std::uint8_t {
    Hit,       ///< range to a surface
    NoReturn,  ///< nothing within the sensor's maximum range (marked invalid, or at or beyond the
               ///< maximum)
    Dropped    ///< NaN, infinite, zero or negative: says nothing
  };

  /** Takes over an observation. The sensor may be mounted upside down (roll of 180°); other tilts
   * are projected to the plane.
   *  @param maxRange_m ranges at or above it count as NoReturn; 0 takes the observation's own
   * maxRange
   *  @param robotFromThen where the robot was when the scan was taken, seen from where it is now */
  void assign(const mrpt::obs::CObservation2DRangeScan& scan, double maxRange_m = 0.0,
              const mrpt::math::TPose2D& robotFromThen = {});

  /** Starts over as a scan of `beams` beams that say nothing; their directions are for the caller
   * to set. */
  void reset(const mrpt::math::TPose2D& robotFromSensor, double maxRange_m, std::size_t beams);
  /** @param measured_m range of a hit; how far nothing was met for NoReturn */
  void setBeam(std::size_t i, Beam what, float measured_m);

  int size() const { return static_cast<int>(range_m.size()); }
  int hits() const { return hits_; }
  int dropped() const { return dropped_; }
  const mrpt::math::TPose2D& robotFromSensor() const { return robotFromSensor_; }
  double maxRange() const { return maxRange_m_; }

  /** Distance from the sensor; for NoReturn how far the view is free, for a laser maxRange(); 0 for
   * Dropped. */
  std::vector<float> range_m;
  std::vector<float> cosine, sine;  ///< direction of the beam in the robot frame
  std::vector<Beam> beam;

  /** What a scan made of a depth image knows besides; empty for lasers. Nearer than start_m a beam
   * does not see the floor, only what is higher than sensorHeight_m · (1 − distance/start_m). */
  std::vector<float> start_m;
  std::vector<float> steepest;  ///< tangent of the elevation of the beam's highest ray
  std::vector<float> top_m;     ///< height of what a Hit met, from the floor
  double sensorHeight_m = 0.0;

 private:
  mrpt::math::TPose2D robotFromSensor_;
  double maxRange_m_ = 0.0;
  int hits_ = 0, dropped_ = 0;
};

}  // namespace bslnav
