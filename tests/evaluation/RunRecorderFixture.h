#pragma once

#include <bslnav/evaluation/RunRecorder.h>

#include <filesystem>

#include "EvaluationRig.h"

namespace bslnav::test {

/** A recorder's configuration, and a directory of its own for every test. */
class RunRecorderTest : public testing::Test {
 protected:
  RunRecorderTest() {
    setup.bind(config);
    std::filesystem::remove_all(directory);
  }
  ~RunRecorderTest() override { std::filesystem::remove_all(directory); }

  static std::string nameOfTest() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }

  const std::string directory = testing::TempDir() + "/bslnav_recorder_" + nameOfTest() + "/deep";
  SimulationSetup setup;
  Config config;
};

}  // namespace bslnav::test
