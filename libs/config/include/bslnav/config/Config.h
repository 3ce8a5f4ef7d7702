#pragma once

#include <bslnav/config/ConfigSection.h>

#include <deque>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace mrpt::config {
class CConfigFileBase;
}

namespace bslnav {

/** The strict configuration of one program: its sections, loaded from INI files and command-line
 * overrides.
 *
 * Files are MRPT INI files (`@define`, `${X}`, `$eval{}`, `$env{}` work). Every key and section
 * must be described, every value complete and in range, every line understood, no key given twice
 * in a file; anything else throws `Error` naming file, section, key and what was expected.
 */
class Config {
 public:
  /** A section of somebody else's: its keys and values as they are. */
  using FreeSection = std::map<std::string, std::string>;

  /** Adds a section whose keys `parameters.describe()` binds; `parameters` must outlive this
   * object. */
  template <typename Parameters>
  void bind(const std::string& name, const std::string& description, Parameters& parameters) {
    parameters.describe(addSection(name, description));
  }

  /** Adds a repeated section: each `[kind:NAME]` in a file makes (or goes on with) entry NAME of
   * `entries`. Entries that are there already are bound, too. */
  template <typename Parameters>
  void bindRepeated(const std::string& kind, const std::string& description,
                    std::map<std::string, Parameters>& entries) {
    for (auto& [name, parameters] : entries)
      bind(std::string(kind).append(":").append(name), description, parameters);
    repeated_.push_back({kind, description,
                         [&entries](const std::string& name, ConfigSection& section) {
                           entries[name].describe(section);
                         },
                         [](ConfigSection& section, const std::function<void()>& use) {
                           Parameters defaults;
                           defaults.describe(section);
                           use();
                         }});
  }

  /** Takes over as they are all sections that nobody has bound and that have a key `marker`, such
   * as `driver` in those of MRPT's sensors. */
  void bindFree(const std::string& marker, const std::string& description,
                std::map<std::string, FreeSection>& sections) {
    free_.push_back({marker, description, &sections});
  }

  /** Loads files in order, later ones override earlier ones, then "section.key=value" overrides.
   *  @throws Error on a missing file, an unknown section or key, or a value that is malformed or
   * out of range. */
  void load(const std::vector<std::string>& files, const std::vector<std::string>& overrides = {});

  /** Loads the sections that this object has from a configuration of MRPT's; what else is in it is
   * MRPT's own.
   *  @param name of it, for messages
   *  @throws Error as load() does */
  void loadOwnSections(const mrpt::config::CConfigFileBase& file, const std::string& name);

  /** Writes every section and key with description, unit, default and accepted values; the output
   * can be loaded again. Repeated sections without an entry are shown as comments. */
  void print(std::ostream& out) const;

  /** Writes every section and key with its value into a configuration of MRPT's. */
  void copyTo(mrpt::config::CConfigFileBase& file) const;

  /** Checks of more than one key: called by the parameters' owner; throws Error naming section and
   * key. */
  [[noreturn]] static void refuse(const std::string& section, const std::string& key,
                                  const std::string& expected);

 private:
  struct Repeated {
    std::string kind, description;
    std::function<void(const std::string&, ConfigSection&)> describe;
    /** Binds a section to default values that live during `use`. */
    std::function<void(ConfigSection&, const std::function<void()>& use)> withDefaults;
  };

  struct Free {
    std::string marker, description;
    std::map<std::string, FreeSection>* sections;
  };

  ConfigSection& addSection(const std::string& name, const std::string& description);
  ConfigSection* findOrMakeSection(const std::string& name);
  ConfigSection& section(const std::string& where, const std::string& name);
  void set(const std::string& where, const std::string& section, const std::string& key,
           const std::string& value);
  FreeSection* findFree(const std::string& name);
  bool loadFree(const mrpt::config::CConfigFileBase& ini, const std::string& name);
  void loadFile(const std::string& file);
  void loadSection(const mrpt::config::CConfigFileBase& ini, const std::string& where,
                   const std::string& name);

  std::deque<ConfigSection> sections_;  // a deque keeps references valid while it grows
  std::vector<Repeated> repeated_;
  std::vector<Free> free_;
};

/** The directory with config/ and maps/: beside the installed program, else the source tree it was
 * built from.
 *  @throws Error when neither exists. */
std::string dataDirectory();
/** A file as given if there is one, else the one of that name in the data directory if there is:
 * what configurations name is found from any directory. */
std::string dataFile(const std::string& file);

}  // namespace bslnav
