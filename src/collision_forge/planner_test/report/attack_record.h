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

/// Post-crash motion of the ego and the touched vehicle, as the page shows it.
struct ShownCrash {
  PostCrashMotion motion;
  double seconds_after_stand = 0.0;  ///< s shown after both have stopped
  std::optional<Track> other = {};   ///< the touched vehicle's motion; empty for the attacker
  std::vector<SecondaryContact> secondary_contacts = {};
};

/// Result of an attack replayed against the recorded ego.
struct RecordedOutcome {
  CollisionReport report;                ///< of verify()
  std::optional<ShownCrash> crash = {};  ///< set if there is a contact
};

/// Returns the page's record of an attack (JSON): everything beyond its row. `attack` is the
/// scenario's attack or one of its alternatives; `recorded` is empty if the recording is not
/// available.
std::string attackRecord(const Scenario& scenario, const Attack& attack,
                         const std::optional<RecordedOutcome>& recorded,
                         const VerificationOptions& options);

/// A figure of a test and the page's link to it.
struct PictureLink {
  std::string name;  ///< shown to the user
  std::string link;  ///< URL relative to the page
};

/// Data of a planner's test beyond its results.
struct ShownTest {
  bool has_attack = false;               ///< the page contains the attack, so motions can be shown
  std::optional<ShownCrash> crash = {};  ///< set if there is a contact
  std::vector<PictureLink> pictures = {};
};

/// Returns the page's record of one planner in one case, as JSON.
std::string plannerRecord(const PlannerTestResult& result, const PlannerRow& row,
                          const ShownTest& shown);

}  // namespace forge
