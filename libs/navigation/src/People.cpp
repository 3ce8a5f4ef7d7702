#include <bslnav/navigation/People.h>

namespace bslnav {
namespace {

void pointTo(const std::vector<PlanarScan>& scans, std::vector<const PlanarScan*>& pointers) {
  pointers.clear();
  for (const PlanarScan& scan : scans) pointers.push_back(&scan);
}

}  // namespace

void People::update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
                    double personSpeed_mps) {
  pointTo(views.lasers, views_.lasers);
  pointTo(views.cameras, views_.cameras);
  pointTo(views.obstacles, views_.obstacles);
  if (views_.lasers.empty() && views_.cameras.empty()) return;
  hidden_.look(views_.lasers, views_.cameras, stamp_s, mapFromRobot, personSpeed_mps);
  seen_.update(views_, stamp_s, mapFromRobot,
               {hidden_.mapped(), hidden_.walls(), hidden_.standing(), hidden_.reached(),
                hidden_.hasBlindSide()},
               personSpeed_mps);
  hidden_.findFrontier(seen_.bodies());
  frontier_.assign(hidden_.frontier().begin(), hidden_.frontier().end());
  frontier_.insert(frontier_.end(), seen_.frontier().begin(), seen_.frontier().end());
}

}  // namespace bslnav
