#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/planners/planner.h"

namespace forge {

/// How a planner is called and its plans are driven.
struct Driving {
  double interval = 0.0;  ///< s between two calls; a multiple of the rollout's step
  /// The ego goes where the plan says, whatever a car can do; otherwise the bicycle follows it.
  bool is_exact = false;
};

/// A planner with how it is called and driven.
struct PlannerUnderTest {
  std::unique_ptr<Planner> planner;
  Driving driving;
};

/// The name of the learned planner, the one that is made of a file.
inline constexpr const char* kTorchscript = "torchscript";

/// "idm", "idm_published", "pdm", "rule_based", "rule_based_tuned", "torchscript".
const std::vector<std::string>& plannerNames();

/// A new planner of plannerNames(). `attacker_id` is for those that the protocol tells who attacks
/// (idm_published). Throws std::invalid_argument for an unknown name, naming the known ones, and
/// PlannerFileError for a learned planner's file that does not fit.
PlannerUnderTest makePlanner(const std::string& name, const PlannerOptions& options,
                             const std::string& attacker_id);

}  // namespace forge
