#include <bslnav/pictures/PictureTiles.h>

#include <algorithm>

#include "PictureHeading.h"

namespace bslnav {

Picture tiled(const std::vector<PictureTile>& tiles, int columns, const std::string& title,
              const Picture& footer) {
  constexpr int kMargin = 20;
  const TextStyle captionStyle{15.0, palette::kInk, true, false};
  const int count = static_cast<int>(tiles.size());
  columns = std::clamp(columns, 1, std::max(1, count));
  int width = 0, height = 0, captionHeight = 0;
  for (const PictureTile& tile : tiles) {
    width = std::max(width, tile.picture.width);
    height = std::max(height, tile.picture.height);
    if (!tile.caption.empty()) captionHeight = 34;
  }
  const int rows = (count + columns - 1) / columns, cellHeight = captionHeight + height + kMargin;
  const int pageWidth = std::max(kMargin + columns * (width + kMargin), footer.width + 2 * kMargin);
  const PictureHeading heading(title, "", pageWidth - 2.0 * kMargin);
  const int top = kMargin + static_cast<int>(heading.height());

  PictureCanvas page(pageWidth, top + rows * cellHeight + footer.height);
  heading.draw(page, {double(kMargin), double(kMargin)});
  for (int i = 0; i < count; ++i) {
    const PictureTile& tile = tiles[static_cast<std::size_t>(i)];
    const int x = kMargin + (i % columns) * (width + kMargin), y = top + (i / columns) * cellHeight;
    page.text({x + width / 2.0, y + 20.0}, tile.caption, captionStyle, TextAlign::Centre);
    page.paste(tile.picture, x + (width - tile.picture.width) / 2, y + captionHeight);
  }
  if (footer.height > 0)
    page.paste(footer, (pageWidth - footer.width) / 2, top + rows * cellHeight);
  return page.finished();
}

Picture stacked(const std::vector<Picture>& pictures) {
  int width = 0, height = 0;
  for (const Picture& picture : pictures) {
    width = std::max(width, picture.width);
    height += picture.height;
  }
  PictureCanvas page(width, height);
  int top = 0;
  for (const Picture& picture : pictures) {
    if (picture.height > 0) page.paste(picture, (width - picture.width) / 2, top);
    top += picture.height;
  }
  return page.finished();
}

}  // namespace bslnav
