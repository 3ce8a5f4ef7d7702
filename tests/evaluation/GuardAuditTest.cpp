#include <bslnav/evaluation/GuardAudit.h>

#include "RawlogRunRig.h"

namespace bslnav {
namespace {

using test::addDrive;
using test::setupOf;
using testing_logs::LogWriter;

GuardAudit auditOf(const RawlogSetup& setup) {
  const LocalizedLog log = localizeLog(setup, 1);
  GuardAudit audit(setup.navigation, log.map);
  evaluateLog(setup, log, 1, [&audit](const RawlogMoment& moment) {
    audit.observe(moment);
    return true;
  });
  return audit;
}

RawlogSetup guarded(LogWriter& log, double seconds) {
  RawlogSetup setup = setupOf(addDrive(log, seconds).close());
  setup.navigation.guard.enabled = true;
  return setup;
}

/** One jump a scan, straight ahead and 4 m away. */
TEST(GuardAudit, TellsWhatBecomesOfEveryJump) {
  LogWriter log("audit_jumps");
  RawlogSetup setup = guarded(log, 4.0);
  for (const double reach_m : {2.0, 8.0}) {
    setup.navigation.hiddenPeople.reach_m = reach_m;
    const GuardFindings f = auditOf(setup).findings();
    EXPECT_EQ(f.scans, 21);
    EXPECT_EQ(f.jumps, 21);
    EXPECT_EQ(f.plausible + f.tooFar + f.nobodyFits + f.seenEmpty, f.jumps);
    if (reach_m < 4.0) {
      EXPECT_EQ(f.tooFar, 21);
    } else {
      EXPECT_EQ(f.tooFar, 0);
      EXPECT_GT(f.plausible, 15);
      EXPECT_GT(f.frontiers, 15);
    }
  }
}

/** The robot drives at 0.5 m/s with an edge of its view 4 m ahead at all times. */
TEST(GuardAudit, FindsWhereTheRobotWasFasterThanTheBound) {
  LogWriter log("audit_speed");
  RawlogSetup setup = guarded(log, 12.0);
  setup.navigation.hiddenPeople.reach_m = 8.0;
  setup.navigation.guard.personSpeed_mps = 0.5;
  const GuardAudit careful = auditOf(setup);
  EXPECT_GE(careful.findings().drivingCycles, 59);
  EXPECT_EQ(careful.findings().exceededCycles, 0);
  EXPECT_TRUE(careful.worst().empty());

  setup.navigation.guard.personSpeed_mps = 6.0;
  const GuardAudit fast = auditOf(setup);
  EXPECT_GT(fast.findings().exceededCycles, 30);
  EXPECT_GT(fast.findings().mostExceeded_mps, 0.1);
  ASSERT_GE(fast.worst().size(), 2u);
  EXPECT_LE(fast.worst().size(), 3u);
  for (std::size_t i = 0; i < fast.worst().size(); ++i) {
    EXPECT_TRUE(fast.worst()[i].record.guard.binding.has_value());
    if (i > 0) {
      EXPECT_GT(std::floor(fast.worst()[i].record.time_s / 5.0),
                std::floor(fast.worst()[i - 1].record.time_s / 5.0));
    }
  }
}

/** Without the guard there is nothing to audit. */
TEST(GuardAudit, SaysNothingWithoutTheGuard) {
  LogWriter log("audit_none");
  const GuardAudit audit = auditOf(setupOf(addDrive(log, 2.0).close()));
  EXPECT_EQ(audit.findings().jumps, 0);
  EXPECT_EQ(audit.findings().drivingCycles, 0);
}

}  // namespace
}  // namespace bslnav
