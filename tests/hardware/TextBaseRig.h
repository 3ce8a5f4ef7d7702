#pragma once

#include <TextBaseEmulator.h>
#include <bslnav/config/Error.h>
#include <bslnav/hardware/TextBase.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>

namespace bslnav::test {

/** The machine may be busy, so a start may take longer than it does by default. */
inline TextBaseParameters at(const std::string& address, double start_s = 5.0) {
  TextBaseParameters parameters;
  parameters.address = address;
  parameters.start_s = start_s;
  return parameters;
}

/** What is thrown by something; empty: nothing is. */
template <typename Action>
std::string errorOf(Action action, Error::Kind kind = Error::Kind::Run) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return {};
}

inline std::string errorOfOpening(const TextBaseParameters& parameters,
                                  Error::Kind kind = Error::Kind::Run) {
  return errorOf([&] { TextBase base(parameters); }, kind);
}

inline double secondsOf(const std::function<void()>& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace bslnav::test
