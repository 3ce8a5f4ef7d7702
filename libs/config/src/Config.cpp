#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/system/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <stdexcept>

#include "IniLines.h"

namespace bslnav {
namespace {

/** Edit distance of two words, for "did you mean". */
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = std::min_element(
      known.begin(), known.end(),
      [&](const auto& a, const auto& b) { return distance(word, a) < distance(word, b); });
  if (nearest == known.end() || distance(word, *nearest) > 1 + word.size() / 3) return "";
  return "; did you mean '" + *nearest + "'?";
}

std::string location(const std::string& file, const std::string& section, const std::string& key) {
  return file + " [" + section + "] " + key;
}

/** @param lead before what is not a comment already */
void printSection(const ConfigSection& section, const std::string& lead, std::ostream& out) {
  out << "; " << section.description() << "\n" << lead << "[" << section.name() << "]\n";
  for (const auto& field : section.fields()) {
    out << "; " << field.description << " ("
        << (field.unit.empty() ? "" : "unit: " + field.unit + "; ")
        << "default: " << (field.defaultText.empty() ? "empty" : field.defaultText) << "; "
        << field.expected << ")\n"
        << lead << field.key << " = " << field.write() << "\n";
  }
  out << "\n";
}

}  // namespace

ConfigSection& Config::addSection(const std::string& name, const std::string& description) {
  sections_.emplace_back(name, description);
  return sections_.back();
}

ConfigSection* Config::findOrMakeSection(const std::string& name) {
  for (auto& section : sections_)
    if (section.name() == name) return &section;
  const auto colon = name.find(':');
  if (colon == std::string::npos || colon + 1 == name.size()) return nullptr;
  for (const auto& repeated : repeated_)
    if (repeated.kind == name.substr(0, colon)) {
      auto& section = addSection(name, repeated.description);
      repeated.describe(name.substr(colon + 1), section);
      return &section;
    }
  return nullptr;
}

ConfigSection& Config::section(const std::string& where, const std::string& name) {
  if (ConfigSection* found = findOrMakeSection(name)) return *found;
  std::vector<std::string> known;
  for (const auto& s : sections_) known.push_back(s.name());
  for (const auto& r : repeated_) known.push_back(r.kind + ":NAME");
  throw Error(where + " [" + name + "]", "unknown section" + suggestion(name, known));
}

Config::FreeSection* Config::findFree(const std::string& name) {
  for (const auto& free : free_) {
    const auto found = free.sections->find(name);
    if (found != free.sections->end()) return &found->second;
  }
  return nullptr;
}

/** Returns whether the section is one of somebody else's. */
bool Config::loadFree(const mrpt::config::CConfigFileBase& ini, const std::string& name) {
  if (findOrMakeSection(name)) return false;
  FreeSection* section = findFree(name);
  for (const auto& free : free_)
    if (!section && ini.keyExists(name, free.marker)) section = &(*free.sections)[name];
  if (!section) return false;
  std::vector<std::string> keys;
  ini.getAllKeys(name, keys);
  for (const auto& key : keys) (*section)[key] = ini.read_string(name, key, "");
  return true;
}

void Config::set(const std::string& where, const std::string& sectionName, const std::string& key,
                 const std::string& value) {
  if (FreeSection* free = findFree(sectionName)) {
    (*free)[key] = value;
    return;
  }
  std::vector<std::string> known;
  for (const auto& field : section(where, sectionName).fields()) {
    known.push_back(field.key);
    if (field.key != key) continue;
    try {
      field.read(value);
    } catch (const std::invalid_argument& problem) {
      throw Error(location(where, sectionName, key),
                  "'" + value + "' is " + problem.what() + "; expected " + field.expected +
                      (field.unit.empty() ? "" : " [" + field.unit + "]"));
    }
    return;
  }
  throw Error(location(where, sectionName, key), "unknown key" + suggestion(key, known));
}

void Config::loadFile(const std::string& file) {
  if (!mrpt::system::fileExists(file))
    throw Error(file, "no such file; expected a configuration (INI)");
  if (std::filesystem::is_directory(file))
    throw Error(file, "is a directory; expected a configuration (INI)");
  checkIniLines(file);
  try {
    const mrpt::config::CConfigFile ini(file);
    std::vector<std::string> names;
    ini.getAllSections(names);
    for (const auto& name : names)
      if (!name.empty())  // MRPT's place for keys before any section: there are none
        loadSection(ini, file, name);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    throw Error(file, std::string("not a readable INI file: ") + problem.what());
  }
}

void Config::loadSection(const mrpt::config::CConfigFileBase& ini, const std::string& where,
                         const std::string& name) {
  if (loadFree(ini, name)) return;
  section(where, name);
  std::vector<std::string> keys;
  ini.getAllKeys(name, keys);
  for (const auto& key : keys) set(where, name, key, ini.read_string(name, key, ""));
}

void Config::loadOwnSections(const mrpt::config::CConfigFileBase& file, const std::string& name) {
  std::vector<std::string> names;
  file.getAllSections(names);
  for (const auto& own : names)
    if (findOrMakeSection(own)) loadSection(file, name, own);
}

void Config::load(const std::vector<std::string>& files,
                  const std::vector<std::string>& overrides) {
  for (const auto& file : files) loadFile(file);
  for (const auto& text : overrides) {
    const auto equals = text.find('=');
    const auto dot = text.rfind('.', equals);
    if (equals == std::string::npos || dot == std::string::npos || dot == 0)
      throw Error("--set " + text, "expected section.key=value");
    set("--set", text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
        text.substr(equals + 1));
  }
}

void Config::print(std::ostream& out) const {
  for (const auto& section : sections_) printSection(section, "", out);
  for (const auto& repeated : repeated_) {
    const auto isEntry = [&](const ConfigSection& section) {
      return section.name().rfind(repeated.kind + ":", 0) == 0;
    };
    if (std::any_of(sections_.begin(), sections_.end(), isEntry)) continue;
    ConfigSection example(repeated.kind + ":NAME", repeated.description);
    repeated.withDefaults(example, [&] { printSection(example, "; ", out); });
  }
  for (const auto& free : free_)
    for (const auto& [name, section] : *free.sections) {
      out << "; " << free.description << "\n[" << name << "]\n";
      for (const auto& [key, value] : section) out << key << " = " << value << "\n";
      out << "\n";
    }
}

void Config::copyTo(mrpt::config::CConfigFileBase& file) const {
  for (const auto& section : sections_)
    for (const auto& field : section.fields()) file.write(section.name(), field.key, field.write());
  for (const auto& free : free_)
    for (const auto& [name, section] : *free.sections)
      for (const auto& [key, value] : section) file.write(name, key, value);
}

void Config::refuse(const std::string& section, const std::string& key,
                    const std::string& expected) {
  throw Error("configuration [" + section + "] " + key, "expected " + expected);
}

}  // namespace bslnav
