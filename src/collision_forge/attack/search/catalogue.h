#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/scene/attack.h"
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
  CollisionRequest request;          ///< what all cells share
  std::vector<CatalogueCell> cells;  ///< one per combination of its grid; empty with `missing`
};

/// Returns true if `attack`, which was found for `request`, also meets `cell`: type, turning,
/// class, manoeuvre, side of the ego and, as measured in `conditions`, the conditions of `cell`.
/// Without `conditions`, a cell that has conditions is not met. A cell with a queue is met only by
/// an attack with one.
bool isInstance(const CollisionRequest& cell, const CollisionRequest& request, const Attack& attack,
                const std::optional<ContactConditions>& conditions);

/// Returns the catalogues in the configuration, sorted by name.
std::vector<std::string> catalogueNames(const ConfigFolder& folder);

/// Returns the entries of one catalogue, or of all for "all", sorted by name. Throws
/// std::invalid_argument for an unknown catalogue, with the known ones; ConfigError for a malformed
/// file, an unknown field and a request that contradicts itself (checkControls()).
std::vector<CatalogueEntry> readCatalogue(const ConfigFolder& folder, const std::string& catalogue);

/// Returns the entries that `names` select, all if `names` is empty. A name is the name of an
/// entry, with or without its catalogue and in any case, and may go on with values of the grid; the
/// entry then keeps the cells with these values: "CCRb deceleration=4". Throws
/// std::invalid_argument for an unknown name or value, with the nearest known one.
std::vector<CatalogueEntry> namedEntries(const std::vector<CatalogueEntry>& entries,
                                         const std::vector<std::string>& names);

/// Returns the cells of namedEntries() for one name. Throws std::invalid_argument as it does, and
/// for a scenario that cannot be requested, with the reason.
std::vector<CatalogueCell> namedCells(const std::vector<CatalogueEntry>& entries,
                                      const std::string& name);

}  // namespace forge
