// drive-base LIBRARY KEY=VALUE: drives with the base of a plugin for half a second.
#include <bslnav/hardware/BasePlugin.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const std::string option = argv[2];
  const auto equals = option.find('=');
  const auto base =
      bslnav::loadBase(argv[1], {{option.substr(0, equals), option.substr(equals + 1)}});
  const double start_s = base->state().stamp_s;
  bslnav::BaseState state;
  for (int i = 0; i < 10; ++i) {
    base->drive({2.0, 0.0, 0.0});
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    state = base->state();
  }
  base->stop();
  const double speed_mps = state.odometry.x / (state.stamp_s - start_s);
  std::printf("the base drove %.3f m at %.2f m/s\n", state.odometry.x, speed_mps);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
