#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class MvsimApp : public AppTest {};

TEST_F(MvsimApp, WorldFileIsWrittenWhenAskedForAndChangesNothing) {
  const std::string room = write("room.ini", kRoom);
  ASSERT_EQ(drive(room, {}, "plain").exitCode, 0);
  EXPECT_FALSE(exists(out("world.mvsim.xml", "plain")));
  ASSERT_EQ(drive(room, {"--set", "recording.mvsim_world=true"}).exitCode, 0);
  EXPECT_THAT(readFile(out("world.mvsim.xml")),
              AllOf(HasSubstr("<mvsim_world"), HasSubstr("<vehicle name=\"robot\">")));
  EXPECT_TRUE(readFile(out("cycles.csv")) == readFile(out("cycles.csv", "plain")));
}

#ifdef BSLNAV_WITH_MVSIM

TEST_F(MvsimApp, DrivesARoom) {
  const AppResult result = drive(write("room.ini", kRoom), {"--set", "simulation.engine=mvsim"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(summary()["outcome"], "goal");
}

#else

TEST_F(MvsimApp, IsRefusedAndSaysThatItsAdapterIsOff) {
  const AppResult result = drive(write("room.ini", kRoom), {"--set", "simulation.engine=mvsim"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("[simulation] engine"), HasSubstr("MVSim support is off"),
                                HasSubstr("CMAKE_PREFIX_PATH")));
  EXPECT_FALSE(exists(out("config.ini")));
}

#endif

}  // namespace
}  // namespace bslnav::test
