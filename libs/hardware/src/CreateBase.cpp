#include <bslnav/config/Error.h>
#include <bslnav/hardware/CreateBase.h>
#include <mrpt/core/Clock.h>

#include <cmath>

#include "CreateSafety.h"
#include "DeviceLine.h"

namespace bslnav {
namespace {

using namespace std::chrono_literals;

constexpr double kRead_s = 0.002;          // a command waits that long, too
constexpr double kWrite_s = 0.05;          // so long a line that takes nothing is waited for
constexpr auto kModeChange = 20ms;         // what the robot needs between two of them
constexpr auto kFirstFrame = 1s;           // frames come every 15 ms
constexpr auto kRepeat = 50ms;             // a command that was damaged on its way counts so long
constexpr auto kSafeModeInterval = 200ms;  // a robot in its dock stays passive, whoever asks

std::string device(const std::string& port) { return port[0] == '/' ? port : "/dev/" + port; }

double seconds(std::chrono::steady_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

}  // namespace

CreateBase::CreateBase(const CreateParameters& parameters)
    : parameters_(parameters),
      keeper_(device(parameters.port), create::fullStop()),
      odometry_(parameters),
      safety_(std::make_unique<CreateSafety>()) {
  open();
  waitForFrame();
  reader_ = std::thread(&CreateBase::run, this);
}

CreateBase::~CreateBase() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  reader_.join();
}

void CreateBase::open() {
  line_ = DeviceLine::open(device(parameters_.port), parameters_.baud);
  write(create::start());
  std::this_thread::sleep_for(kModeChange);
  write(create::safe());
  std::this_thread::sleep_for(kModeChange);
  write(create::fullStop() + create::stream());
}

void CreateBase::waitForFrame() {
  const auto until = Clock::now() + kFirstFrame;
  do {
    receive();
    if (state_.stamp_s != 0.0) return;
  } while (Clock::now() < until);
  throw Error(parameters_.port,
              "no robot answers: expected a Create 2 or Roomba, switched on, at " +
                  std::to_string(parameters_.baud) + " baud",
              Error::Kind::Run);
}

BaseState CreateBase::state() {
  const std::lock_guard<std::mutex> lock(mutex_);
  requireLine();
  return state_;
}

void CreateBase::drive(const mrpt::math::TTwist2D& command) {
  const bool finite = std::isfinite(command.vx) && std::isfinite(command.omega);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    requireLine();
    wanted_ = finite ? command : mrpt::math::TTwist2D();
    wantedAt_ = Clock::now();
  }
  if (!finite) throw Error(parameters_.port, "a command is not a finite number", Error::Kind::Run);
}

void CreateBase::stop() noexcept {
  const std::lock_guard<std::mutex> lock(mutex_);
  wanted_ = {};
}

std::size_t CreateBase::badChecksums() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return badChecksums_;
}

bool CreateBase::isEnding() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ending_;
}

void CreateBase::requireLine() const {
  if (lost_) throw *lost_;
}

void CreateBase::run() noexcept {
  try {
    while (!isEnding()) {
      receive();
      askForSafeMode();
      sendWheels();
    }
    write(create::fullStop());
  } catch (const Error& problem) {
    const std::lock_guard<std::mutex> lock(mutex_);
    lost_ = problem;
  }
}

void CreateBase::receive() {
  for (const char byte : line_->read(kRead_s))
    if (const auto sensors = parser_.feed(static_cast<std::uint8_t>(byte))) take(*sensors);
  const std::lock_guard<std::mutex> lock(mutex_);
  badChecksums_ = parser_.badChecksums();
}

void CreateBase::take(const CreateSensors& sensors) {
  safety_->sensed(sensors);
  odometry_.add(sensors.leftCounts, sensors.rightCounts, seconds(Clock::now()));
  const std::lock_guard<std::mutex> lock(mutex_);
  state_.stamp_s = mrpt::Clock::nowDouble();
  state_.odometry = odometry_.pose();
  state_.twist = odometry_.twist();
  state_.halt = sensors.halt();
}

void CreateBase::askForSafeMode() {
  if (!safety_->needsSafeMode() || Clock::now() - askedForSafeModeAt_ < kSafeModeInterval) return;
  write(create::safe());
  safety_->askedForSafeMode();
  askedForSafeModeAt_ = Clock::now();
}

CreateWheels CreateBase::permittedWheels() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::chrono::duration<double> age = Clock::now() - wantedAt_;
  if (age.count() > parameters_.commandTimeout_s) return {};
  return safety_->permitted(wanted_, parameters_);
}

void CreateBase::sendWheels() {
  const CreateWheels wheels = permittedWheels();
  if (wheels == sent_ && Clock::now() - sentAt_ < kRepeat) return;
  write(create::driveDirect(wheels));
  sent_ = wheels;
  sentAt_ = Clock::now();
}

void CreateBase::write(std::string_view bytes) {
  if (line_->write(bytes, kWrite_s) < bytes.size())
    throw Error(parameters_.port, "the line takes no more bytes; expected a robot that reads them",
                Error::Kind::Run);
}

}  // namespace bslnav
