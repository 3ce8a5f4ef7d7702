#include <bslnav/costmap/MapLoader.h>
#include <bslnav/navigation/MrptSetup.h>
#include <mrpt/system/string_utils.h>

namespace bslnav {

void MrptSetup::describe(ConfigSection& section) {
  section.text("config", config, "bslnav's INI files, separated by commas; later ones override");
  section.integer("method", method, {1, 99}, "",
                  "method: the overlay config/methods/methodN.ini, after those files");
  section.text("map", map, "static map: a file, or none");
}

void MrptSetup::load(const mrpt::config::CConfigFileBase& file) {
  const std::string name = "MRPT's configuration";
  Config own;
  own.bind("bslnav", "What bslnav adds to MRPT's navigation.", *this);
  own.loadOwnSections(file, name);

  std::vector<std::string> words, files;
  mrpt::system::tokenize(config, ",", words);
  for (const auto& word : words)
    if (auto trimmed = mrpt::system::trim(word); !trimmed.empty()) files.push_back(trimmed);
  files.push_back(dataDirectory() + "/config/methods/method" + std::to_string(method) + ".ini");
  Config parameters;
  navigation.bind(parameters);
  parameters.load(files);
  parameters.loadOwnSections(file, name);
  navigation.check();
}

std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> MrptSetup::makeMap() const {
  return map == "none" ? nullptr : loadMap(map);
}

}  // namespace bslnav
