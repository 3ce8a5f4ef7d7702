#pragma once

#include <string>
#include <vector>

#include "PictureCanvas.h"

namespace bslnav {

/** The title and subtitle at the top of a page, broken to its width. */
class PictureHeading {
 public:
  PictureHeading(const std::string& title, const std::string& subtitle, double width);

  /** Of the texts with the space below them; 0 when both are empty. */
  double height() const;
  void draw(PictureCanvas& canvas, const PagePoint& topLeft) const;

 private:
  std::vector<std::string> title_, subtitle_;
};

}  // namespace bslnav
