#pragma once

#include <bslnav/config/Error.h>
#include <bslnav/hardware/Base.h>
#include <bslnav/hardware/CreateKinematics.h>
#include <bslnav/hardware/CreateParameters.h>
#include <bslnav/hardware/CreateProtocol.h>
#include <bslnav/hardware/Keeper.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace bslnav {

class CreateSafety;
class DeviceLine;

/** An iRobot Create 2, or a Roomba, on its Open Interface over a serial line.
 *
 * Such a robot drives on with its last command for ever. The wheels are stopped when no command
 * comes any more, when this object goes, and when this process ends in whatever way; a pulled cable
 * alone nobody can bridge. With a bump or a cliff it drives backwards only, with a wheel off the
 * floor not at all; the state tells why. Once over, it is ready again by itself. */
class CreateBase : public Base {
 public:
  /** Waits for the first frame, up to 1 s.
   *  @throws Error (Run) that names the port, when it cannot be used or no robot answers */
  explicit CreateBase(const CreateParameters& parameters);
  ~CreateBase() override;

  BaseState state() override;
  /** Within the wheels' top speed, with the curvature kept; vy is left out.
   *  @throws Error (Run) when the line is gone, or a command is not finite: then it stops, too */
  void drive(const mrpt::math::TTwist2D& command) override;
  void stop() noexcept override;

  /** How many frames came damaged, and were dropped. */
  std::size_t badChecksums() const;

 private:
  using Clock = std::chrono::steady_clock;

  void open();
  void waitForFrame();
  void run() noexcept;
  void receive();
  void take(const CreateSensors& sensors);
  void askForSafeMode();
  void sendWheels();
  CreateWheels permittedWheels() const;
  void write(std::string_view bytes);
  bool isEnding() const;
  void requireLine() const;  // with the mutex locked

  const CreateParameters parameters_;
  Keeper keeper_;

  // Used by the constructor, then by the reader alone: so nobody waits for a slow line.
  std::unique_ptr<DeviceLine> line_;
  CreateFrameParser parser_;
  CreateOdometry odometry_;
  std::unique_ptr<CreateSafety> safety_;
  CreateWheels sent_;
  Clock::time_point sentAt_, askedForSafeModeAt_;

  mutable std::mutex mutex_;  // for all below
  BaseState state_;
  mrpt::math::TTwist2D wanted_;
  Clock::time_point wantedAt_;
  std::size_t badChecksums_ = 0;
  std::optional<Error> lost_;  // why there is no line any more
  bool ending_ = false;

  std::thread reader_;  // the last, for it uses all others
};

}  // namespace bslnav
