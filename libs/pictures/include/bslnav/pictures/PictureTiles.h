#pragma once

#include <bslnav/pictures/Picture.h>

#include <string>
#include <vector>

namespace bslnav {

struct PictureTile {
  Picture picture;
  std::string caption;  ///< for example "t = 12.3 s"
};

/** Puts pictures beside each other, row by row, `columns` a row, each under its caption.
 *  Every tile gets the size of the largest one. @param title above all of them; empty for none
 *  @param footer below all of them, for example their legend */
Picture tiled(const std::vector<PictureTile>& tiles, int columns, const std::string& title = "",
              const Picture& footer = {});

/** Puts pictures below each other, each in the middle of the widest one's width. */
Picture stacked(const std::vector<Picture>& pictures);

}  // namespace bslnav
