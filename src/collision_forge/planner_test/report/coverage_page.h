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

/// Numbers of one planner's tests of the attacks of one cell.
struct PlannerCoverage {
  std::size_t hit = 0;  ///< rollouts in which the attacker hit the planner's ego
  /// Part of `hit`: an evasive manoeuvre was found (PlannerRow::evasion).
  std::size_t avoidable = 0;
  /// All other rollouts without a failure of the planner, including contacts with other agents.
  std::size_t passed = 0;
};

/// Results of the requests that were made from one cell of a catalogue, and of other requests whose
/// attack meets it.
struct CellCoverage {
  std::size_t requests = 0;  ///< number of requests that were made from the cell
  /// Requests that the road allows: without StatusCode::kRoadDoesNotAllow.
  std::size_t possible = 0;
  std::size_t generated = 0;  ///< requests with an attack, StatusCode::kOk
  /// Attacks that meet the cell (isInstance()) of requests of other cells or of none.
  std::size_t others = 0;
  /// Number of rejected requests by the name of their StatusCode.
  std::map<std::string, std::size_t> reasons;
  std::map<std::string, PlannerCoverage> planners;  ///< by rowName(); only tested planners
};

/// Counts the results of scenario files and planner tests by the cells of catalogues.
class Coverage {
 public:
  /// `catalogue`: the entries whose cells attacks may meet, and the rows of the page.
  explicit Coverage(std::vector<CatalogueEntry> catalogue);

  /// Counts a request of a scenario file in the cell that it was made from (SceneRequest::name; in
  /// none if this is empty), and its attack, without alternatives, in all other cells that it meets
  /// (isInstance()). `name`: the case name of the scenario in planner tests, FILE:LINE (file name
  /// without folder and extension, line from 1 on). `measured`: the conditions at the contact; if
  /// empty, the report's conditions count, which files have only for requests with conditions.
  void add(const Scenario& scenario, const std::string& name,
           const std::optional<ContactConditions>& measured = std::nullopt);
  /// Counts every row of a test whose planner did not fail, in each cell in which the scenario with
  /// its case name was counted before; ignores other tests and untested cases.
  void add(const PlannerTestResult& result);

  /// Returns true if no request was made from a catalogue and no attack meets a cell.
  bool empty() const { return cells_.empty(); }

  /// Returns an HTML page with each catalogue that has a counted request or attack (a cell's name
  /// begins with the catalogue's name and '/'), by name: its entries in the order given to the
  /// constructor, and their cells with the counts. A counted cell that is not in the catalogue is
  /// left out. Names the reason for rejections, marks cells without a request, and gives the reason
  /// for entries that cannot be requested.
  std::string page() const;

 private:
  std::vector<CatalogueEntry> catalogue_;
  std::map<std::string, CellCoverage> cells_;                      ///< by CatalogueCell::name
  std::map<std::string, std::vector<std::string>> cells_of_case_;  ///< names of cells by case name
};

}  // namespace forge
