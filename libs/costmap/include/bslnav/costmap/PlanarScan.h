#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** A horizontal scan made ready for the control cycle: checked ranges and directions in the robot
 * frame.
 *
 * Beams run counterclockwise. Built once a cycle from MRPT's observation; assigning to the same
 * object again does not allocate.
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
   * maxRange */
  void assign(const mrpt::obs::CObservation2DRangeScan& scan, double maxRange_m = 0.0);

  int size() const { return static_cast<int>(range_m.size()); }
  int hits() const { return hits_; }
  int dropped() const { return dropped_; }
  const mrpt::math::TPose2D& robotFromSensor() const { return robotFromSensor_; }
  double maxRange() const { return maxRange_m_; }

  std::vector<float> range_m;  ///< distance from the sensor; maxRange() for NoReturn, 0 for Dropped
  std::vector<float> cosine, sine;  ///< direction of the beam in the robot frame
  std::vector<Beam> beam;

 private:
  mrpt::math::TPose2D robotFromSensor_;
  double maxRange_m_ = 0.0;
  int hits_ = 0, dropped_ = 0;
};

}  // namespace bslnav
