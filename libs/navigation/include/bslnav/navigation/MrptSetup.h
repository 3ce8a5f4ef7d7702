#pragma once

#include <bslnav/navigation/NavigationParameters.h>
#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <memory>
#include <string>

namespace bslnav {

/** bslnav's part of a configuration of MRPT's navigation: section [bslnav] names files, and any of
 * bslnav's own sections ([limits], [footprint], [dwa], ...) may stand beside MRPT's. */
struct MrptSetup {
  std::string config;        ///< bslnav's INI files, separated by commas; later ones override
  int method = 1;            ///< the overlay config/methods/methodN.ini, after those files
  std::string map = "none";  ///< static map: a file, or "none"
  NavigationParameters navigation;

  void describe(ConfigSection& section);
  /** Loads [bslnav], then what it names, then bslnav's sections beside it.
   *  @throws Error */
  void load(const mrpt::config::CConfigFileBase& file);
  /** Null without a map. @throws Error */
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> makeMap() const;
};

}  // namespace bslnav
