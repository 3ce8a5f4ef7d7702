#include <bslnav/costmap/CostGrid.h>

#include <algorithm>
#include <cstring>

namespace bslnav {

void CostGrid::shift(int dx, int dy, Cost fill) {
  if (dx == 0 && dy == 0) return;
  const CellWindow kept = bounds().intersected(bounds().shifted(-dx, -dy));  // where old cells land
  if (kept.empty()) {
    std::fill(m_map.begin(), m_map.end(), fill);
  } else {
    // Rows follow each other, so that one move does all; what it carries across the sides is
    // filled.
    Cost *const first = row(kept.y0) + kept.x0, *const last = row(kept.y1 - 1) + kept.x1;
    std::memmove(first, first + (static_cast<std::ptrdiff_t>(dy) * width() + dx),
                 static_cast<std::size_t>(last - first));
    std::fill(row(0), row(kept.y0), fill);
    for (int y = kept.y0; y < kept.y1; ++y) {
      std::fill(row(y), row(y) + kept.x0, fill);
      std::fill(row(y) + kept.x1, row(y) + width(), fill);
    }
    std::fill(row(kept.y1), row(height()), fill);
  }
  const double cells = std::round(m_x_min / m_resolution) + dx,
               rows = std::round(m_y_min / m_resolution) + dy;
  m_x_min = cells * m_resolution;
  m_y_min = rows * m_resolution;
  m_x_max = (cells + width()) * m_resolution;
  m_y_max = (rows + height()) * m_resolution;
}

}  // namespace bslnav
