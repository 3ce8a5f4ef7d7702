#include <bslnav/navigation/People.h>

namespace bslnav {

void People::update(const std::vector<PlanarScan>& scans, double stamp_s,
                    const mrpt::math::TPose2D& mapFromRobot, double personSpeed_mps) {
  views_.clear();
  for (const PlanarScan& scan : scans) views_.push_back(&scan);
  if (views_.empty()) return;
  hidden_.update(views_, stamp_s, mapFromRobot, personSpeed_mps);
  seen_.update(views_, stamp_s, mapFromRobot, hidden_.solid(), personSpeed_mps);
  frontier_.assign(hidden_.frontier().begin(), hidden_.frontier().end());
  frontier_.insert(frontier_.end(), seen_.frontier().begin(), seen_.frontier().end());
}

}  // namespace bslnav
