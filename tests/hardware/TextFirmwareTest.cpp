// The firmware that share/doc/base-protocol.md shows, with what an Arduino gives it.
#include <PseudoTerminal.h>
#include <TextBaseEmulator.h>
#include <bslnav/config/Error.h>
#include <bslnav/hardware/TextBase.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <sstream>

namespace arduino {

using byte = unsigned char;

struct String : std::string {
  using std::string::string;
  String(const std::string& text) : std::string(text) {}
  String(unsigned long number) : std::string(std::to_string(number)) {}
  String(double number, int decimals) {
    std::ostringstream text;
    text.precision(decimals);
    text << std::fixed << number;
    assign(text.str());
  }
};

struct SerialPort {
  void begin(long) {}
  int available() {
    if (heard.empty()) heard = terminal.read(0.001);
    return static_cast<int>(heard.size());
  }
  int read() {
    const int first = static_cast<unsigned char>(heard.front());
    heard.erase(0, 1);
    return first;
  }
  void print(const std::string& text) { terminal.write(text); }

  bslnav::test::PseudoTerminal terminal;
  std::string heard;
};

SerialPort Serial;

unsigned long millis() {
  using namespace std::chrono;
  static const auto start = steady_clock::now();
  return static_cast<unsigned long>(
      duration_cast<milliseconds>(steady_clock::now() - start).count() + 1000);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#include "../../share/examples/base-firmware/base-firmware.ino"
#pragma GCC diagnostic pop

std::atomic<double> wheels_mps{0.0};

void setWheels(double forward, double, double) { wheels_mps = forward; }
void readOdometry(double& atX, double& atY, double& atPhi) { atX = 1.5, atY = -2.5, atPhi = 0.25; }
const char* reasonToStand() { return "bumper"; }

}  // namespace arduino

namespace bslnav::test {
namespace {

TEST(TextFirmware, SpeaksTheProtocol) {
  std::atomic<bool> ending{false};
  arduino::setup();
  std::thread board([&] {
    while (!ending) arduino::loop();
  });
  {
    TextBaseParameters parameters;
    parameters.address = arduino::Serial.terminal.path();
    parameters.start_s = 5.0;
    TextBase base(parameters);
    EXPECT_EQ(base.state().odometry, mrpt::math::TPose2D(1.5, -2.5, 0.25));
    EXPECT_EQ(base.state().halt, "bumper");
    const auto told = [&] { return base.state().twist.vx; };
    EXPECT_TRUE(eventually([&] { return base.drive({0.5, 0.0, 0.0}), told() == 0.5; }));
    EXPECT_EQ(arduino::wheels_mps, 0.5);
    EXPECT_TRUE(eventually([&] { return told() == 0.0 && arduino::wheels_mps == 0.0; }));
    EXPECT_TRUE(eventually([&] { return base.drive({0.5, 0.0, 0.0}), told() == 0.5; }));
    base.stop();
    EXPECT_TRUE(eventually([&] { return told() == 0.0; }));
    EXPECT_EQ(base.counts().refused, 0);
  }
  ending = true;
  board.join();
}

std::string contentOf(const std::string& file) {
  std::ifstream input(BSLNAV_SOURCE_DIR "/" + file);
  return {std::istreambuf_iterator<char>(input), {}};
}

TEST(TextFirmware, IsShownInTheDocument) {
  const std::string firmware = contentOf("share/examples/base-firmware/base-firmware.ino");
  ASSERT_FALSE(firmware.empty());
  EXPECT_NE(contentOf("share/doc/base-protocol.md").find("```cpp\n" + firmware + "```"),
            std::string::npos);
}

TEST(TextFirmware, TheLinesOfTheDocumentAreRight) {
  std::istringstream document(contentOf("share/doc/base-protocol.md"));
  int lines = 0;
  for (std::string line; std::getline(document, line);) {
    if (const auto at = line.find('$'); at == 2 && (line[0] == '>' || line[0] == '<')) {
      ++lines;
      EXPECT_TRUE(fromTextLine(line.substr(at, line.find(' ', at) - at))) << line;
    }
  }
  EXPECT_GT(lines, 8);
}

}  // namespace
}  // namespace bslnav::test
