#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/statistics/rate_table.h"

namespace forge {

/// The evaluation protocol: study/evaluation/published.h or attack/verify/strict_outcome.h.
enum class Protocol { kPublished, kStrict };
/// Returns "published" or "strict".
const char* toString(Protocol protocol);

/// Returns the measures of a protocol, in the order of ResultRow::meets. Published: collision,
/// similar. Strict: all conditions by angle bands, by full definitions, then each condition.
const std::vector<Measure>& measuresOf(Protocol protocol);

/// Columns of results.csv that only rows of requests have.
struct RequestFacts {
  std::optional<bool> road_allows;  ///< roadAllows() for the recorded ego; empty: no frame at t0
  std::optional<bool> believable;   ///< plausible up to the recorded contact; empty: no contact
  std::string attacker;  ///< id of the attacker; empty without an attack and for baselines
  std::optional<AgentClass> attacker_class;  ///< empty if `attacker` is
};

/// The result of one method on one clip or request: a row of results.csv.
struct ResultRow {
  std::string name;   ///< clip name, or line of the request in its list
  std::string scene;  ///< name
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;  ///< s, nominal for clips
  std::string method;
  std::uint64_t seed = 0;
  std::string status;                      ///< "OK", or the status code of the rejection
  std::vector<bool> meets;                 ///< one per measure of the protocol
  std::optional<double> contact_after;     ///< s from t0 to contact, negative before t0
  std::optional<double> relative_heading;  ///< rad, between ego and attacker at contact
  std::optional<double> confidence;        ///< predicted by the search, 0..1
  /// Mean share, 0..1, of the attacker's box off the drivable area from t0 to contact.
  std::optional<double> off_road_share;
  std::string note;  ///< broken limit, other agent touched, reason of implausibility or rejection
  std::optional<RequestFacts> request;  ///< requests only
};

/// The items of results.csv.
enum class RowsOf { kClips, kRequests };

// Header and line of results.csv, without line ends. Times have three decimals, shares four,
// headings are in degrees with two. toCsv() throws std::runtime_error for a name or scene with
// commas or line ends.
std::string csvHeader(Protocol protocol, RowsOf rows_of = RowsOf::kClips);
std::string toCsv(const ResultRow& row);

/// Parses a line of toCsv(), of a request if it has the columns of requests. Returns nullopt for a
/// malformed or truncated line.
std::optional<ResultRow> rowFromCsv(const std::string& line, Protocol protocol);

/// Parses the rows of one item, one per line. Throws std::runtime_error if a line is malformed or
/// its column `name` differs from `name`; `where` (file and line) begins the message.
std::vector<ResultRow> readResultRows(const std::string& where, const std::string& lines,
                                      Protocol protocol, const std::string& name);

}  // namespace forge
