#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/statistics/rate_table.h"

namespace forge {

/// The evaluation protocol: kPublished in study/evaluation/published.h, kStrict in
/// attack/verify/strict_outcome.h.
enum class Protocol { kPublished, kStrict };
/// Returns "published" or "strict".
const char* toString(Protocol protocol);

/// Returns the measures of a protocol, in the order of ResultRow::meets; names of their columns in
/// brackets. Published: hit (collision), similar hit (similar). Strict: all conditions by angle
/// bands (angle_bands), all by full definitions (full_definitions), then each condition: contact
/// after t0 (contact), type by angle bands (type_angle_bands), type by full definitions
/// (type_full), on time (on_time), limits kept (limits_kept), no earlier contact with another agent
/// (nobody_before). The reference is always valid.
const std::vector<Measure>& measuresOf(Protocol protocol);

/// Columns of results.csv that only rows of requests have.
struct RequestFacts {
  /// roadAllows() for the recorded ego; empty if the scene has no frame at t0.
  std::optional<bool> road_allows;
  std::optional<bool> believable;  ///< the attack is plausible up to its contact with the recorded
                                   ///< ego; empty without contact
  std::string attacker;  ///< id of the attacker; empty without an attack and for baselines
  std::optional<AgentClass> attacker_class;  ///< class of `attacker`; empty if that is
};

/// The result of one method on one clip or request: a row of results.csv.
struct ResultRow {
  std::string name;   ///< clip name, or line of the request in its list, from 1
  std::string scene;  ///< name of the scene
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;         ///< s, requested; for clips at the nominal 2 Hz
  std::string method;       ///< methodsOf() for clips, requestRowMethods() for requests
  std::uint64_t seed = 0;   ///< seed of the method's run; 0, or the request's, for a method that
                            ///< is not seeded
  std::string status;       ///< "OK", or the status code of the rejection
  std::vector<bool> meets;  ///< one per measure of measuresOf(), all false without an attack
  /// s from t0 to the contact of ego and attacker, in the published protocol to the first collision
  /// of either; negative before t0, empty without.
  std::optional<double> contact_after;
  /// rad, attacker's yaw minus ego's at contact, in the published protocol its magnitude; empty
  /// without contact.
  std::optional<double> relative_heading;
  /// CollisionReport::confidence, 0..1; empty without an attack and for methods that are not
  /// seeded, for clips also without a contact in CollisionReport and in the published protocol.
  std::optional<double> confidence;
  /// Mean share, 0..1, of the attacker's box off the drivable area from t0 to contact; strict
  /// protocol only, empty without contact.
  std::optional<double> off_road_share;
  std::string note;  ///< broken limit, other agent touched, reason of implausibility or rejection
  std::optional<RequestFacts> request;  ///< empty for clips
};

/// The items whose rows results.csv has.
enum class RowsOf { kClips, kRequests };

// Header and line of results.csv, without line ends. Columns: name, scene, type, tta, method, seed,
// status, the measures of measuresOf() (1 or 0), contact_after, relative_heading, confidence,
// off_road_share, for requests road_allows, believable (1 or 0), attacker, class, and last note.
// Empty values are empty cells. contact_after has three decimals, tta up to six significant digits,
// shares have four decimals; headings are in degrees with two. toCsv() throws std::runtime_error
// for a name or scene with commas or line ends; commas and line ends in other texts are replaced.
/// Returns the header: the names of all columns.
std::string csvHeader(Protocol protocol, RowsOf rows_of = RowsOf::kClips);
/// Returns the line of a row.
std::string toCsv(const ResultRow& row);

/// Parses a line of toCsv(), without its line end, of a request if it has the columns of requests.
/// Returns nullopt for a malformed or truncated line.
std::optional<ResultRow> rowFromCsv(const std::string& line, Protocol protocol);

/// Parses the rows of one item, one per line. Throws std::runtime_error if a line is malformed or
/// its column `name` differs from `name`; `where` (file and line) begins the message.
std::vector<ResultRow> readResultRows(const std::string& where, const std::string& lines,
                                      Protocol protocol, const std::string& name);

}  // namespace forge
