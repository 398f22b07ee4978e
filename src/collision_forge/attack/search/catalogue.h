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
  /// name of the entry and values of the grid, sorted by field: "euro_ncap_2026/CCRm
  /// attacker_speed=5.56"
  std::string name;
  /// without attacker, TTA, seed and crash definition, which have their defaults
  CollisionRequest request;
};

/// A scenario that a test programme names, of a file config/catalogue/NAME.yaml; docs/catalogue.md
/// describes the keys of the file.
struct CatalogueEntry {
  std::string name;  ///< catalogue and scenario: "euro_ncap_2026/CCRm"
  std::string text;  ///< what happens, for people
  /// how the request differs from the programme, for people; empty if it does not
  std::string differs;
  std::string missing;       ///< why it cannot be requested, for people; empty if it can
  CollisionRequest request;  ///< what all cells share, without the fields of the grid; unchanged
                             ///< defaults with `missing`
  /// one per combination of its grid's values, the last field varies fastest; one without a grid;
  /// empty with `missing`. A number becomes the range of that value plus and minus the tolerance in
  /// the file.
  std::vector<CatalogueCell> cells;
};

/// Returns true if `attack`, which was found for `request`, also meets `cell`: type and turning (of
/// `request`), class, manoeuvre, side of the ego and, as measured in `conditions` at the contact of
/// `attack`, the conditions of `cell`: `from_side`, `hidden_by` and kRangeControls. Without
/// `conditions`, a cell that has conditions is not met. A cell with a queue is met only if
/// `request` has one too or `attack` has a support vehicle of role kQueue. Ignores `impact_speed`
/// and `overlap` of `cell`.
bool isInstance(const CollisionRequest& cell, const CollisionRequest& request, const Attack& attack,
                const std::optional<ContactConditions>& conditions);

/// Returns the names of the catalogues in the configuration (files catalogue/NAME.yaml, without
/// extension), sorted; empty without such files.
std::vector<std::string> catalogueNames(const ConfigFolder& folder);

/// Returns the entries of one catalogue, or of all for "all", sorted by catalogue and name. Throws
/// std::invalid_argument for an unknown catalogue, with the known ones; ConfigError for a malformed
/// file, an unknown field and a request that contradicts itself (checkControls()).
std::vector<CatalogueEntry> readCatalogue(const ConfigFolder& folder, const std::string& catalogue);

/// Returns the entries that `names` select, in the order of `names`; all if `names` is empty. A
/// name is the name of an entry, with or without its catalogue and in any case, and may go on with
/// values of the grid, spelt as in CatalogueCell::name; the entry then keeps the cells with all of
/// these values: "CCRb deceleration=4". A short name selects its entries in all catalogues. An
/// entry that two names select appears twice. Throws std::invalid_argument for an unknown name or
/// value, with the nearest known one.
std::vector<CatalogueEntry> namedEntries(const std::vector<CatalogueEntry>& entries,
                                         const std::vector<std::string>& names);

/// Returns the cells of namedEntries() for one name. Throws std::invalid_argument as it does, and
/// for a scenario that cannot be requested, with the reason.
std::vector<CatalogueCell> namedCells(const std::vector<CatalogueEntry>& entries,
                                      const std::string& name);

}  // namespace forge
