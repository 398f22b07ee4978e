#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// One set of parameters of a named scenario.
struct CatalogueCell {
  std::string name;          ///< "euro_ncap_2026/CCRm attacker_speed=5.56"
  CollisionRequest request;  ///< without attacker, TTA and crash definition
};

/// A scenario that a test programme names, of a file config/catalogue/NAME.yaml.
struct CatalogueEntry {
  std::string name;                  ///< "euro_ncap_2026/CCRm"
  std::string text;                  ///< what happens
  std::string differs;               ///< how the request differs from the programme; may be empty
  std::string missing;               ///< why it cannot be requested; empty if it can
  std::vector<CatalogueCell> cells;  ///< one per combination of its grid; empty with `missing`
};

/// Returns the catalogues in the configuration, sorted by name.
std::vector<std::string> catalogueNames(const ConfigFolder& folder);

/// Returns the entries of one catalogue, or of all for "all", sorted by name. Throws
/// std::invalid_argument for an unknown catalogue, with the known ones; ConfigError for a malformed
/// file, an unknown field and a request that contradicts itself (checkControls()).
std::vector<CatalogueEntry> readCatalogue(const ConfigFolder& folder, const std::string& catalogue);

/// Returns the entries whose name, with or without its catalogue, is in `names`; all if `names` is
/// empty. Throws std::invalid_argument for a name without entry, with the nearest known one.
std::vector<CatalogueEntry> namedEntries(const std::vector<CatalogueEntry>& entries,
                                         const std::vector<std::string>& names);

}  // namespace forge
