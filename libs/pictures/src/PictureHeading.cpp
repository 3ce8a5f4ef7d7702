#include "PictureHeading.h"

namespace bslnav {
namespace {

const TextStyle kTitle{18.0, palette::kInk, true, false};
const TextStyle kSubtitle{13.5, palette::kFaintInk, false, false};
constexpr double kTitleLine = 32.0, kSubtitleLine = 25.0, kSpaceBelow = 14.0;

}  // namespace

PictureHeading::PictureHeading(const std::string& title, const std::string& subtitle, double width)
    : title_(wrapped(title, kTitle, width)), subtitle_(wrapped(subtitle, kSubtitle, width)) {}

double PictureHeading::height() const {
  if (title_.empty() && subtitle_.empty()) return 0.0;
  return kTitleLine * static_cast<double>(title_.size()) +
         kSubtitleLine * static_cast<double>(subtitle_.size()) + kSpaceBelow;
}

void PictureHeading::draw(PictureCanvas& canvas, const PagePoint& topLeft) const {
  double y = topLeft.y;
  for (const std::string& line : title_) {
    canvas.text({topLeft.x, y + kTitle.capHeight_px}, line, kTitle);
    y += kTitleLine;
  }
  for (const std::string& line : subtitle_) {
    canvas.text({topLeft.x, y + kSubtitle.capHeight_px}, line, kSubtitle);
    y += kSubtitleLine;
  }
}

}  // namespace bslnav
