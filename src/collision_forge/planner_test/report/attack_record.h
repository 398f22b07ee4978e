#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Post-crash motion of the ego and the touched vehicle, as the page shows it. All poses are in the
/// global map frame.
struct ShownCrash {
  PostCrashMotion motion;            ///< of the ego and, as attackerAt(), of the touched vehicle
  double seconds_after_stand = 0.0;  ///< s of motion shown after both vehicles have stopped
  /// Track of a touched vehicle other than the attacker, whose states before the contact are shown;
  /// empty if the attacker was touched
  std::optional<Track> other = {};
  /// secondaryContacts(): later contacts of either vehicle with other agents.
  std::vector<SecondaryContact> secondary_contacts = {};
};

/// Result of an attack replayed against the recorded ego.
struct RecordedOutcome {
  CollisionReport report;  ///< of verify() against the recorded future
  /// nullopt if the attacker does not touch the recorded ego.
  std::optional<ShownCrash> crash = {};
};

/// Returns the page's record of an attack as one line of JSON without a line end: everything beyond
/// its ReportRow, with times relative to t0. Keys: "ego_length", "ego_width", "request",
/// "attacker", "supports", "aim", "report", "recorded", "crash", "limits" and "plans"; motions as
/// writeTrajectory(). The program in page/ (detail.js) reads them.
///
/// - "aim": of the attack's pattern, "t" (s), the box centres "ego" and "attacker" (map frame), and
///   "miss_distance" (m, PatternMiss::distance).
/// - "report", "recorded": as writeCollisionReport(), of `attack.report` and `recorded->report`.
/// - "crash": the motions "ego" and "other" from the contact on ("other" begins with the states of
///   ShownCrash::other, if set), and "secondary_contacts" ("t", "is_ego", "agent"). Missing if
///   `recorded->crash` is nullopt.
/// - "limits": "of" ("strict" or the attacker's vehicle class), "max_forward_acceleration",
///   "max_braking" and "max_lateral_acceleration" (strict: in any direction), m/s2, and
///   "max_speed", m/s.
/// - "plans": writePlans() of `scenario.plans` if `attack` is `scenario.answer`; an alternative has
///   an empty array. Therefore `attack` must refer to `scenario.answer` or to one of its
///   alternatives, and must not be a copy.
///
/// `recorded`: nullopt if the recording is not available; the record then lacks the keys "recorded"
/// and "crash". `options`: source of the shown limits of the request's limit set.
std::string attackRecord(const Scenario& scenario, const Attack& attack,
                         const std::optional<RecordedOutcome>& recorded,
                         const VerificationOptions& options);

/// A figure of a test and the page's link to it.
struct PictureLink {
  std::string name;  ///< shown to the user
  std::string link;  ///< percent-encoded URL relative to the page, linkTo()
};

/// Data that the page shows of a planner's test beyond its results.
struct ShownTest {
  /// The page contains the tested attack, so the motions of the test are shown.
  bool has_attack = false;
  /// Motion after the ego's contact; nullopt without a contact, or if motions are missing.
  std::optional<ShownCrash> crash = {};
  std::vector<PictureLink> pictures = {};  ///< figures of the test, picturesBeside()
};

/// Returns the page's record of one planner in one case as one line of JSON without a line end:
/// "avoidability" of the case, the fields of writePlannerRow(), "drive", and "pictures" ("name" and
/// "link" of each). "drive" has the motions "ego", "attacker" and, if the row has an evasion drive,
/// "evasion", as writeTrajectory(); "crash" as in attackRecord(), if `shown.crash` is set; and
/// "plans" as writePlans(). The key "drive", and `shown.crash` with it, is left out without
/// `shown.has_attack` and if dropMotions() has removed the motions. `row`: an element of
/// `result.rows`.
std::string plannerRecord(const PlannerTestResult& result, const PlannerRow& row,
                          const ShownTest& shown);

}  // namespace forge
