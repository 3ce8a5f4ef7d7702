#include <bslnav/hardware/SensorProcess.h>
#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <utility>

#include "DriverProcess.h"

namespace bslnav {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRead_s = 0.05;        // so long an end may take to be noticed
constexpr std::size_t kMostKept = 200;  // observations that nobody takes
constexpr double kMostPatience = 8.0;   // times the configured silence

std::string iniOf(const std::string& name, const Config::FreeSection& section) {
  std::ostringstream text;
  text << "[" << name << "]\n";
  for (const auto& [key, value] : section) text << key << " = " << value << "\n";
  return text.str();
}

}  // namespace

SensorProcess::SensorProcess(std::string name, const Config::FreeSection& section, Options options)
    : name_(std::move(name)),
      ini_(iniOf(name_, section)),
      options_(std::move(options)),
      thread_([this] { supervise(); }) {}

SensorProcess::~SensorProcess() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  endingChanged_.notify_all();
  thread_.join();
}

std::vector<mrpt::obs::CObservation::Ptr> SensorProcess::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(observations_, {});
}

SensorProcess::Status SensorProcess::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

void SensorProcess::startAgain(const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  toEnd_ = why;
}

bool SensorProcess::waitOrEnd(double time_s) {
  std::unique_lock<std::mutex> lock(mutex_);
  return endingChanged_.wait_for(lock, std::chrono::duration<double>(time_s),
                                 [this] { return ending_; });
}

void SensorProcess::supervise() {
  // A driver that ends before it has read its section is no reason to end.
  sigset_t pipe;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
  double patience = 1.0;
  do {
    std::string trouble;
    const int before = status().observations;
    try {
      DriverProcess driver(options_.program, name_, ini_, options_.logFile);
      trouble = listen(driver, patience * options_.silence_s);
      const std::string end = driver.end();
      if (trouble.empty()) trouble = end;
    } catch (const std::exception& problem) {
      trouble = problem.what();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    status_.trouble = trouble;
    status_.process = -1;
    const bool inVain = status_.observations == before;
    patience = inVain ? std::min(2.0 * patience, kMostPatience) : 1.0;
  } while (!waitOrEnd(options_.again_s));
}

/** Until the driver's process ends, is silent for too long, or is to end; returns what was the
 * trouble, empty when the process says more by how it ends.
 * @param silence_s so long it may take to deliver first */
std::string SensorProcess::listen(const DriverProcess& driver, double silence_s) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++status_.starts;
    status_.process = driver.id();
    toEnd_.reset();
  }
  SensorMessageReader reader;
  std::string trouble;
  for (auto heard = Clock::now();;) {
    const auto bytes = driver.read(kRead_s);
    if (!bytes) return trouble;
    reader.add(bytes->data(), bytes->size());
    while (const auto message = reader.next()) {
      accept(*message);
      if (message->kind == SensorMessage::Kind::Trouble) {
        trouble = message->bytes;
      } else {
        heard = Clock::now();
        silence_s = options_.silence_s;
      }
    }
    if (std::chrono::duration<double>(Clock::now() - heard).count() > silence_s)
      return trouble.empty() ? "the driver delivers nothing" : trouble;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (toEnd_) return *toEnd_;
    if (ending_) return trouble;
  }
}

void SensorProcess::accept(const SensorMessage& message) {
  const bool isTrouble = message.kind == SensorMessage::Kind::Trouble;
  auto observation = isTrouble ? nullptr : observationOf(message);
  const std::lock_guard<std::mutex> lock(mutex_);
  status_.trouble = isTrouble ? message.bytes : std::string();
  if (isTrouble) return;
  ++status_.observations;
  if (observations_.size() >= kMostKept) observations_.erase(observations_.begin());
  observations_.push_back(std::move(observation));
}

}  // namespace bslnav
