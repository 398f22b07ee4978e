#pragma once

#include <string>
#include <vector>

#include "collision_forge/statistics/rate_table.h"
#include "collision_forge/study/attack_figures.h"
#include "collision_forge/study/options.h"
#include "collision_forge/study/result_row.h"
#include "collision_forge/study/scorecard.h"

namespace forge {

/// How much like recorded vehicles the attackers of some methods drive.
struct ScorecardReport {
  std::string markdown;  ///< all tables, without a title
  std::string csv;       ///< the same, by rateCsvHeader(), with that header
  /// Shares for a chart, each with the rows of the methods and last that of recorded vehicles.
  std::vector<RateTable> shares;
};

/// Of the rows with an attack, for each of `methods` in turn, and of what recorded vehicles do in
/// the same scenes: where on the road they drive (an attack's lanes and its direction until
/// before_contact before the contact that its method expects), the least gap to others, the peaks
/// of steering rate, jerk and lateral acceleration as shares of the limits of their class, by type
/// and TTA, and the scorecards (scorecardOf()). Cells of fewer than `min_windows` of the options
/// are left out of quantiles and scorecards. The same arguments give the same report.
ScorecardReport reportScorecard(const std::vector<ResultRow>& rows,
                                const std::vector<std::string>& methods,
                                const std::vector<RecordedMotion>& recorded,
                                const StudyOptions& options);

}  // namespace forge
