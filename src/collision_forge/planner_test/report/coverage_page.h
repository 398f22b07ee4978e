#pragma once

#include <cstddef>
#include <map>
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
  /// All other rollouts, including failures of the planner and contacts with other agents.
  std::size_t passed = 0;
};

/// Results of the requests that were made from one cell of a catalogue.
struct CellCoverage {
  std::size_t requests = 0;  ///< number of requests
  /// Requests that the road allows: without StatusCode::kRoadDoesNotAllow.
  std::size_t possible = 0;
  std::size_t generated = 0;  ///< requests with an attack, StatusCode::kOk
  /// Number of rejected requests by the name of their StatusCode.
  std::map<std::string, std::size_t> reasons;
  std::map<std::string, PlannerCoverage> planners;  ///< by rowName(); only tested planners
};

/// Counts the results of scenario files and planner tests by the cells of catalogues.
class Coverage {
 public:
  /// Counts a request of a scenario file; ignores a request that was not made from a catalogue
  /// (empty SceneRequest::name). `name`: the case name of the scenario in planner tests, FILE:LINE
  /// (file name without folder and extension, line from 1 on).
  void add(const Scenario& scenario, const std::string& name);
  /// Counts every row of a test whose case name was added with a scenario before; ignores other
  /// tests and untested cases.
  void add(const PlannerTestResult& result);

  /// Returns true if no request was made from a catalogue.
  bool empty() const { return cells_.empty(); }

  /// Returns an HTML page with each catalogue that has a counted request (a cell's name begins with
  /// the catalogue's name and '/'), by name: its entries of `catalogue` in their order, and their
  /// cells with the counts. A counted cell that is not in `catalogue` is left out. Names the reason
  /// for rejections, marks cells without a request, and gives the reason for entries that cannot be
  /// requested.
  std::string page(const std::vector<CatalogueEntry>& catalogue) const;

 private:
  std::map<std::string, CellCoverage> cells_;        ///< by CatalogueCell::name
  std::map<std::string, std::string> cell_of_case_;  ///< name of the cell by case name
};

}  // namespace forge
