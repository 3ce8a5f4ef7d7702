#pragma once

#include <bslnav/campaign/Campaign.h>

#include <optional>
#include <string>
#include <vector>

#include "CommandLine.h"

namespace bslnav {

/** The options of `campaign`. */
struct CampaignOptions {
  CommonOptions common;
  std::vector<int> methods{1, 2, 3, 4, 5};
  std::vector<std::string> engines{"dwa"}, sensors{"both"};
  long encounters = 80, emptyEvery = 1;
  int jobs = 0;
  std::optional<long> replay;  ///< number of an encounter

  void addTo(CLI::App& command);
};

/** The campaign that the options describe.
 *  @param leftOut entrants that there cannot be, each with the reason
 *  @throws Error also when no entrant is left */
Campaign makeCampaign(const CampaignOptions& options, std::vector<std::string>& leftOut);

}  // namespace bslnav
