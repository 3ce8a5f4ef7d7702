#include <PseudoTerminal.h>
#include <gtest/gtest.h>
#include <mrpt/comms/CSerialPort.h>

namespace bslnav::test {
namespace {

TEST(PseudoTerminal, IsASerialLineForMrptsPort) {
  PseudoTerminal line;
  mrpt::comms::CSerialPort port(line.path(), true);
  port.setConfig(115200);
  port.setTimeouts(100, 0, 100, 0, 0);
  EXPECT_EQ(port.Write("\x91\n\r", 3), 3u);
  EXPECT_EQ(line.read(0.5), "\x91\n\r");
  ASSERT_TRUE(line.write(std::string_view("a\0\xff", 3)));
  std::string got(3, ' ');
  ASSERT_EQ(port.Read(got.data(), 3), 3u);
  EXPECT_EQ(got, std::string("a\0\xff", 3));
}

TEST(PseudoTerminal, PulledItsUserNotices) {
  PseudoTerminal line;
  mrpt::comms::CSerialPort port(line.path(), true);
  port.setTimeouts(10, 0, 10, 0, 0);
  line.hangUp();
  char byte = 0;
  EXPECT_EQ(port.Read(&byte, 1), 0u);
  EXPECT_FALSE(port.isOpen());
}

}  // namespace
}  // namespace bslnav::test
