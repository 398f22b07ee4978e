#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Numbers of a planner's tests in the attacks of one cell.
struct PlannerCoverage {
  std::size_t hit = 0;        ///< the attacker hit the planner's ego
  std::size_t avoidable = 0;  ///< part of `hit`: an evasive manoeuvre was known
  std::size_t passed = 0;     ///< tested without such a hit
};

/// Results of the requests that were made from one cell of a catalogue, and of other requests whose
/// attack meets it.
struct CellCoverage {
  std::size_t requests = 0;
  std::size_t possible = 0;   ///< requests that the road allows
  std::size_t generated = 0;  ///< requests with an attack
  std::size_t others = 0;     ///< attacks of requests of other cells or of none that meet it
  std::map<std::string, std::size_t> reasons;       ///< rejections by StatusCode
  std::map<std::string, PlannerCoverage> planners;  ///< by rowName()
};

/// Counts the results of scenario files and planner tests by the cells of catalogues.
class Coverage {
 public:
  /// `catalogue`: the rows of the page.
  explicit Coverage(std::vector<CatalogueEntry> catalogue);

  /// Adds a scenario to the cell that its request was made from, and its attack to all cells that
  /// it meets (isInstance()). `name`: its case name. `measured`: the conditions of its contact; if
  /// empty, the report's, which files have only for requests with conditions.
  void add(const Scenario& scenario, const std::string& name,
           const std::optional<ContactConditions>& measured = std::nullopt);
  /// Adds a test of the scenario with the result's case name; ignores an unknown one.
  void add(const PlannerTestResult& result);

  /// Returns true if no request was made from a catalogue and no attack meets a cell.
  bool empty() const { return cells_.empty(); }

  /// Returns an HTML page: the entries and cells of each catalogue that has a count, with their
  /// counts; cells without a request or attack, and entries that cannot be requested, with the
  /// reason.
  std::string page() const;

 private:
  std::vector<CatalogueEntry> catalogue_;
  std::map<std::string, CellCoverage> cells_;                      ///< by CatalogueCell::name
  std::map<std::string, std::vector<std::string>> cells_of_case_;  ///< names of cells by case name
};

}  // namespace forge
