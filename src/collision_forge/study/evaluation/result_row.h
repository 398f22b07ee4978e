#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/attack_figures.h"

namespace forge {

/// How a clip is judged: study/evaluation/published.h or attack/verify/strict_outcome.h.
enum class Protocol { kPublished, kStrict };
const char* toString(Protocol protocol);

/// Published: collision, similar. Strict: all conditions by angle bands and by full definitions,
/// then each condition.
const std::vector<Measure>& measuresOf(Protocol protocol);

/// What rows of requests over logs say beyond those of clips.
struct RequestFacts {
  std::optional<bool> road_allows;      ///< roadAllows() on the recorded ego; empty: no such moment
  std::optional<bool> believable;       ///< of the contact in the recording, if there is one
  std::optional<AttackFigures> attack;  ///< of an answer, if the method is no baseline
};

/// How one method did in one clip or request: a row of results.csv.
struct ResultRow {
  std::string name;  ///< of the clip; of a request its line in the list
  std::string scene;
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;  ///< s, nominal in a clip
  std::string method;
  std::uint64_t seed = 0;
  std::string status;                      ///< "OK", or why the method has no answer
  std::vector<bool> meets;                 ///< one a measure
  std::optional<double> contact_after;     ///< s from now to contact, negative before
  std::optional<double> relative_heading;  ///< rad at contact
  std::optional<double> confidence;        ///< promised by the search, [0, 1]
  /// Mean share of the attacker's box off the drivable area from now to contact, [0, 1], and that
  /// of its own recorded motion over the same span.
  std::optional<double> off_road_share;
  std::optional<double> own_off_road_share;
  std::string note;  ///< a broken limit, whom else the attacker touches, what no driver would do
  std::optional<RequestFacts> request;  ///< of requests alone
};

/// What results.csv has a row of.
enum class RowsOf { kClips, kRequests };

/// Both without the line's end. Times have three decimals, shares four, headings are degrees with
/// two. toCsv() throws std::runtime_error for a name or scene with commas or line ends.
std::string csvHeader(Protocol protocol, RowsOf rows_of = RowsOf::kClips);
std::string toCsv(const ResultRow& row);

/// The row of a line as toCsv() writes it, of a request if it has their columns; empty for any
/// other line (one that was cut off).
std::optional<ResultRow> rowFromCsv(const std::string& line, Protocol protocol);

/// The rows of an item of that name, a line each. Throws std::runtime_error for lines that are none
/// of its rows; `where` says where they stand.
std::vector<ResultRow> readResultRows(const std::string& where, const std::string& lines,
                                      Protocol protocol, const std::string& name);

}  // namespace forge
