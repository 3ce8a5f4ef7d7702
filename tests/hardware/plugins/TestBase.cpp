#include <bslnav/config/Error.h>
#include <bslnav/hardware/BasePlugin.h>

#include <stdexcept>

namespace {

/** Tells its options and its last command; its constructor fails on request. */
class TestBase : public bslnav::Base {
 public:
  explicit TestBase(const std::map<std::string, std::string>& options) {
    if (options.count("error")) throw bslnav::Error("option error", options.at("error"));
    if (options.count("exception")) throw std::out_of_range(options.at("exception"));
    if (options.count("number")) throw 42;
    if (options.count("halt")) state_.halt = options.at("halt");
  }
  bslnav::BaseState state() override {
    if (state_.twist.vx < 0.0)
      throw bslnav::Error("test base", "is gone", bslnav::Error::Kind::Run);
    return state_;
  }
  void drive(const mrpt::math::TTwist2D& command) override { state_.twist = command; }
  void stop() noexcept override { state_.twist = {}; }

 private:
  bslnav::BaseState state_;
};

}  // namespace

BSLNAV_BASE_PLUGIN(TestBase);
