#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Verdict on a planner or a careful driver in one cell of a sweep.
enum class SweepVerdict {
  kAvoided,   ///< no contact
  kHit,       ///< the first contact is with the attacker
  kHitOther,  ///< the first contact is with another agent
  kFailed,    ///< a failure of the planner ended the rollout
  kRejected,  ///< the request has no attack, or it cannot be tested
  kMixed,     ///< several cells with different verdicts
};
/// Returns "avoided", "hit", "hit_other", "failed", "rejected" or "mixed".
const char* toString(SweepVerdict verdict);

/// The layout of a sweep, the same for all its cells.
struct SweepLayout {
  std::vector<std::string> parameters;  ///< names of the varied parameters
  bool is_grid = true;                  ///< false: a Latin hypercube
  std::string x;                        ///< parameter on the map's horizontal axis
  std::string y;                        ///< on the vertical axis; "" if one parameter is varied
};

/// One cell: the values of the parameters, as SweepAxis::values, and the tests of its request.
struct SweepCell {
  std::vector<double> values;
  PlannerTestResult result;
};

/// Outcome for a planner or a careful driver in one cell.
struct SweepOutcome {
  std::string name;        ///< rowName() of a planner, or the driver model
  bool is_driver = false;  ///< of a careful driver
  SweepVerdict verdict = SweepVerdict::kAvoided;
  double impact_speed = 0.0;  ///< m/s of a planner's contact, else 0
};

/// Returns the outcomes of the planners, then of the careful drivers; none for a rejected cell.
std::vector<SweepOutcome> outcomesOf(const SweepCell& cell);

/// Returns the number of cells with each status, most frequent first, as "12 OK, 3 NO_CANDIDATE".
std::string statusCounts(const std::vector<SweepCell>& cells);

/// Returns one line of sweep.jsonl (docs/sweeps.md). `index` counts from 0.
std::string sweepLine(const SweepLayout& layout, const SweepCell& cell, std::size_t index);

/// Returns the file sweep.csv: the values before the columns of results.csv.
std::string sweepCsv(const SweepLayout& layout, const std::vector<SweepCell>& cells);

}  // namespace forge
