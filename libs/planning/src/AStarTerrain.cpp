#include <bslnav/planning/AStarTerrain.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace bslnav {

void AStarTerrain::assign(const CostGrid& grid, bool allowUnknown) {
  const Cost unknown = allowUnknown ? kHighestGradedCost + 1 : 0;
  stride_ = grid.width() + 2;
  const int rows = grid.height() + 2;
  cells_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows), 0);
  regions_.resize(cells_.size());
  for (int y = 0; y < grid.height(); ++y) {
    const Cost* from = grid.row(y);
    std::transform(from, from + grid.width(), &cells_[index(0, y)], [unknown](Cost cost) {
      const Cost passable = static_cast<Cost>(cost + 1);
      return cost < kInscribedCost ? passable : cost == kUnknownCost ? unknown : Cost{0};
    });
  }
  const cv::Mat mask(rows, stride_, CV_8U, cells_.data());
  cv::Mat regions(rows, stride_, CV_32S, regions_.data());  // right size and type: filled in place
  cv::connectedComponents(mask, regions, 4, CV_32S);
}

}  // namespace bslnav
