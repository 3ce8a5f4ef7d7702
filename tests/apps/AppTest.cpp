#include "AppTest.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace bslnav::test {

namespace fs = std::filesystem;

const char* const kRoom = R"([scenario]
name = room
start = 0 0 0
goals = 2 0 0
time_limit_s = 30

[wall:room]
points_m = -1 -2, 5 -2, 5 2, -1 2, -1 -2

[laser:front]
z_m = 0.25
)";

const char* const kS1 = BSLNAV_SOURCE_DIR "/config/scenarios/s1.ini";

std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

AppTest::AppTest() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string("apps_") + info->test_suite_name() + "_" + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  directory_ = testing::TempDir() + name;
  fs::remove_all(directory_);
  fs::create_directories(directory_);
}

AppResult AppTest::run(const Arguments& arguments, const std::string& program) const {
  return AppProcess(program, arguments, directory_).wait();
}

AppResult AppTest::drive(const std::string& config, Arguments arguments,
                         const std::string& name) const {
  arguments.insert(arguments.begin(), config);
  arguments.insert(arguments.end(), {"--out", path(name)});
  return run(arguments);
}

std::string AppTest::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name);
}

nlohmann::json AppTest::summary(const std::string& name) const {
  return nlohmann::json::parse(readFile(out("summary.json", name)));
}

bool exists(const std::string& path) { return fs::exists(path); }

std::size_t rowsOf(const std::string& csv) {
  const std::string text = readFile(csv);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) - 1;
}

nlohmann::json withoutTimings(nlohmann::json summary) {
  for (auto item = summary.begin(); item != summary.end();) {
    const std::string& key = item.key();
    const bool timing = key.size() > 3 && key.compare(key.size() - 3, 3, "_ms") == 0;
    item = timing ? summary.erase(item) : std::next(item);
  }
  for (const char* key : {"wall_s", "times_faster_than_recording"})
    if (summary.contains("rawlog")) summary["rawlog"].erase(key);
  return summary;
}

}  // namespace bslnav::test
