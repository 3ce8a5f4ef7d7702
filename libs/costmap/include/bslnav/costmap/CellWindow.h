#pragma once

#include <algorithm>

namespace bslnav {

/** A half-open rectangle of cells, [x0, x1) × [y0, y1); empty when x0 >= x1 or y0 >= y1. */
struct CellWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
  int width() const { return empty() ? 0 : x1 - x0; }
  int height() const { return empty() ? 0 : y1 - y0; }
  bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }

  /** The smallest window that holds both. */
  CellWindow united(const CellWindow& o) const {
    if (empty()) return o;
    if (o.empty()) return *this;
    return {std::min(x0, o.x0), std::min(y0, o.y0), std::max(x1, o.x1), std::max(y1, o.y1)};
  }
  CellWindow intersected(const CellWindow& o) const {
    return {std::max(x0, o.x0), std::max(y0, o.y0), std::min(x1, o.x1), std::min(y1, o.y1)};
  }
  /** Grown by `cells` to every side; an empty window stays empty. */
  CellWindow grown(int cells) const {
    if (empty()) return *this;
    return {x0 - cells, y0 - cells, x1 + cells, y1 + cells};
  }
  CellWindow shifted(int dx, int dy) const { return {x0 + dx, y0 + dy, x1 + dx, y1 + dy}; }

  bool operator==(const CellWindow& o) const {
    return (empty() && o.empty()) || (x0 == o.x0 && y0 == o.y0 && x1 == o.x1 && y1 == o.y1);
  }
};

}  // namespace bslnav
