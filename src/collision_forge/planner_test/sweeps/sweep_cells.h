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
  kMixed,     ///< in a map only: several cells with different verdicts
};
/// Returns "avoided", "hit", "hit_other", "failed", "rejected" or "mixed".
const char* toString(SweepVerdict verdict);

/// The layout of a sweep, the same for all its cells.
struct SweepLayout {
  std::vector<std::string> parameters;  ///< names of the varied parameters (SweepParameter::name),
                                        ///< in the order of SweepCell::values
  bool is_grid = true;                  ///< false: a Latin hypercube
  std::string x;                        ///< name of the parameter on the map's horizontal axis
  std::string y;  ///< name of the parameter on the vertical axis; "" if one parameter is varied
};

/// One cell of a sweep: a request with certain values, and its tests.
struct SweepCell {
  std::vector<double> values;  ///< numbers or indices of words as SweepAxis::values, one per
                               ///< SweepLayout::parameters
  PlannerTestResult result;    ///< tests of all planners in the request's attack
};

/// Outcome for a planner or a careful driver in one cell.
struct SweepOutcome {
  std::string name;        ///< rowName() of a planner, or CarefulDrive::driver
  bool is_driver = false;  ///< true: a careful driver in the recorded ego's place; false: a planner
  SweepVerdict verdict = SweepVerdict::kAvoided;  ///< neither kRejected nor kMixed
  double impact_speed = 0.0;  ///< m/s of a planner's first contact with any agent; 0 without
                              ///< contact and for careful drivers
};

/// Returns the outcomes of the planners (PlannerTestResult::rows), then of the careful drivers, in
/// their order; empty if the cell could not be tested.
std::vector<SweepOutcome> outcomesOf(const SweepCell& cell);

/// Returns the number of cells with each status, most frequent first (equally frequent ones by
/// name), as "12 OK, 3 NO_CANDIDATE"; "" without cells.
std::string statusCounts(const std::vector<SweepCell>& cells);

/// Returns one line of sweep.jsonl (docs/sweeps.md) without a line end. `index` of the cell counts
/// from 0, the number "cell" in the line from 1. Words are written as words, numbers in full
/// precision. Motions are in the line if the result has them.
std::string sweepLine(const SweepLayout& layout, const SweepCell& cell, std::size_t index);

/// Returns the content of sweep.csv: a header with the columns "cell", SweepParameter::name of each
/// varied parameter, "careful_drivers" and plannerResultCsvHeader(), then the cells in order. A
/// cell has one line per element of plannerResultCsvRows(), so one per planner, policy and
/// background; a rejected cell has one, with its status and empty columns of the planner. "cell"
/// counts from 1; values are as SweepParameter::text(), words as words; "careful_drivers" names the
/// drivers that avoid the crash in the recorded ego's place, separated by spaces.
std::string sweepCsv(const SweepLayout& layout, const std::vector<SweepCell>& cells);

}  // namespace forge
