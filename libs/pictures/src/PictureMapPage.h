#pragma once

#include <bslnav/pictures/MapPicture.h>

#include "PictureCanvas.h"
#include "PictureHeading.h"
#include "PictureLegend.h"

namespace bslnav {

/** Where the parts of a map picture stand on its page, and the map's scale; pixels. */
struct PictureMapLayout {
  PictureMapLayout(const MapBounds& wanted, const MapPictureOptions& options);

  /** Continuous position inside the data area of a point in the map frame [m]. */
  PagePoint inData(const mrpt::math::TPoint2D& p) const {
    return {(p.x - bounds.xMin_m) * scale_pxpm, (bounds.yMax_m - p.y) * scale_pxpm};
  }

  int margin, leftAxis, bottomAxis;  ///< around the data area
  bool legendBelow = true;
  double scale_pxpm = 1.0;
  int width = 0, height = 0;  ///< of the data area
  MapBounds bounds;           ///< as wanted, grown where the data area would be too narrow to read
};

/** What a MapPicture consists of: the data area, already drawn, and what goes around it at the end.
 */
struct MapPicture::Page {
  Page(const std::string& title, const std::string& subtitle, const MapBounds& bounds,
       const MapPictureOptions& options);

  PagePoint origin() const;
  std::vector<PagePoint> inData(const std::vector<mrpt::math::TPoint2D>& points) const;
  Picture finished() const;

  PictureMapLayout layout;
  PictureHeading heading;
  PictureCanvas data;
  PictureLegend legend;
  bool withLegend, withAxes;

 private:
  double gridStep() const;
  void drawGrid();
  void drawAxes(PictureCanvas& page) const;
};

}  // namespace bslnav
