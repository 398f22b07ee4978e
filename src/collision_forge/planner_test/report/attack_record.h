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

/// What the ego and the vehicle that it touches do after a contact, as the page shows it.
struct ShownCrash {
  PostCrashMotion motion;
  double seconds_after_stand = 0.0;  ///< from when both stand to the end of what is shown
  std::optional<Track> other = {};   ///< the touched vehicle as it drove; empty for the attacker
};

/// An attack against the recording.
struct RecordedOutcome {
  CollisionReport report;                ///< of verify()
  std::optional<ShownCrash> crash = {};  ///< with a contact
};

/// What the page tells of one attack beyond its row, as JSON. `attack` is the scenario's answer or
/// one of its alternatives; `recorded` is empty where the recording is not known.
std::string attackRecord(const Scenario& scenario, const Realization& attack,
                         const std::optional<RecordedOutcome>& recorded,
                         const VerificationOptions& options);

/// A picture of a test, as the page links to it.
struct PictureLink {
  std::string name;
  std::string link;
};

/// What is known of a planner's test beyond its results.
struct ShownTest {
  bool has_attack = false;               ///< the page has the attack, so that motions can be shown
  std::optional<ShownCrash> crash = {};  ///< after a contact
  std::vector<PictureLink> pictures = {};
};

/// What the page tells of one planner in one case.
std::string plannerRecord(const PlannerTestResult& result, const PlannerRow& row,
                          const ShownTest& shown);

}  // namespace forge
