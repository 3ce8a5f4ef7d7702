#pragma once

#include <bslnav/hardware/Base.h>
#include <mrpt/core/Clock.h>

#include <mutex>

namespace bslnav::test {

/** A base that does at once as it is told, and remembers it. */
class RecordingBase : public Base {
 public:
  BaseState state() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    state_.stamp_s = mrpt::Clock::nowDouble();
    state_.twist = command_;
    return state_;
  }
  void drive(const mrpt::math::TTwist2D& command) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    command_ = command;
  }
  void stop() noexcept override {
    const std::lock_guard<std::mutex> lock(mutex_);
    command_ = {};
    ++stops_;
  }

  mrpt::math::TTwist2D command() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return command_;
  }
  int stops() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return stops_;
  }

 private:
  mutable std::mutex mutex_;
  BaseState state_;
  mrpt::math::TTwist2D command_;
  int stops_ = 0;
};

}  // namespace bslnav::test
