#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/data/json_line.h"
#include "collision_forge/data/scenario_file.h"
#include "collision_forge/trials/planner_result.h"
#include "collision_forge/verify/options.h"

namespace forge {

/// What the page tells of one attack beyond its row, as JSON. `attack` is the scenario's answer or
/// one of its alternatives; `recorded` is what verify() says of it against the recording, where
/// that is known.
std::string attackRecord(const Scenario& scenario, const Realization& attack,
                         const std::optional<CollisionReport>& recorded,
                         const VerificationOptions& options);

/// A picture of a test, as the page links to it.
struct PictureLink {
  std::string name;
  std::string link;
};

/// What is known of a planner's test beyond its results.
struct ShownTest {
  std::optional<RolloutOutcome> driven = {};  ///< with its motions, where it was driven again
  std::optional<Escape> escape = {};          ///< of the ego that was hit there
  std::vector<PictureLink> pictures = {};
};

/// What the page tells of one planner in one case.
std::string plannerRecord(const PlannerTestResult& result, const PlannerRow& row,
                          const ShownTest& shown);

}  // namespace forge
