#pragma once

#include <bslnav/hardware/Base.h>

#include <map>
#include <memory>
#include <string>

/** What a plugin and its user must agree on: Base, BaseState and the functions below. To be changed
 * with any of them. */
#define BSLNAV_BASE_PLUGIN_VERSION "bslnav base 1"

namespace bslnav {

/** A base from a shared library that was made with BSLNAV_BASE_PLUGIN.
 *
 * The library stays loaded until the program ends: an exception that it threw may outlive its base.
 *
 *  @param library a path; without a slash it is looked for where the system has its libraries
 *  @param options what the base's constructor gets
 *  @throws Error naming the library: (Configuration) when it is missing, no such library or made
 *  for another bslnav; of the kind of the constructor's own Error, or else (Run), when the base
 *  cannot be made */
std::unique_ptr<Base> loadBase(const std::string& library,
                               const std::map<std::string, std::string>& options);

}  // namespace bslnav

/** Once in a shared library, outside of any namespace: makes it a plugin whose base is `MyBase`,
 * which is constructed from a `const std::map<std::string, std::string>&`. */
#define BSLNAV_BASE_PLUGIN(MyBase)                                                          \
  extern "C" __attribute__((visibility("default"))) const char* bslnavBasePluginVersion() { \
    return BSLNAV_BASE_PLUGIN_VERSION;                                                      \
  }                                                                                         \
  extern "C" __attribute__((visibility("default"))) bslnav::Base* bslnavMakeBase(           \
      const std::map<std::string, std::string>& options) {                                  \
    return new MyBase(options);                                                             \
  }                                                                                         \
  static_assert(true, "a semicolon may follow")
