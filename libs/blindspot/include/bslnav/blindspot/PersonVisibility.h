#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/DepthBeams.h>

#include <vector>

namespace bslnav {

struct PersonVisibilityParameters {
  double height_m = 1.5;  ///< of the smallest person who counts
  double floor_m = 0.1;   ///< what is lower is floor, its noise and unevenness

  void describe(ConfigSection& section);
};

/** Makes a scan of a depth image that tells in each direction how far a person would be seen.
 *
 * A person is a column from the floor up to a height. Somebody at a distance is hidden only if
 * every pixel's ray that passes there between the floor and this height is blocked before; the
 * range of a beam is the largest distance at which somebody would be seen (share/doc/guard.md,
 * step 1). So a low table hides nobody, and what hangs above the view does not blind. A beam is a
 * Hit where something ends the view, NoReturn where the rays run out: on the floor, above the head,
 * or at the camera's maximum range. A pixel without depth sees nobody, and no pixel counts without
 * the one above it. A camera that is not below the height of a person sees nobody either: it looks
 * over those who stand near. One object for one camera: it keeps a table of the image's rays. */
class PersonVisibility {
 public:
  explicit PersonVisibility(const PersonVisibilityParameters& parameters = {})
      : parameters_(parameters) {}

  /** @param frame of status Ok. The scan is in its robot frame [m] and valid until the next call;
   * no allocation while the camera stays the same. */
  const PlanarScan& make(const DepthFrame& frame);

 private:
  struct View {  // of one beam
    float farthest_m, blocked_m;
  };

  void layOut(const DepthFrame& frame);
  void takeRow(int v);

  PersonVisibilityParameters parameters_;
  PlanarScan scan_;
  DepthBeams beams_;
  std::vector<float> leaves_m_;  // of each pixel: where its ray leaves the height of people
  std::vector<float> seen_m_, above_m_, blocked_m_;  // of a row of pixels
  std::vector<View> views_;
};

}  // namespace bslnav
