#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/planners/planner.h"

namespace forge {

/// How often a planner is called and how the ego follows its plans.
struct Driving {
  double interval = 0.0;  ///< s between two calls; a multiple of the rollout's step
  /// True: the ego follows the plan exactly, without vehicle limits. False: the kinematic bicycle
  /// follows it.
  bool is_exact = false;
};

/// A planner with its driving settings.
struct PlannerUnderTest {
  std::unique_ptr<Planner> planner;
  Driving driving;
};

/// Name of the learned planner, which is loaded from a file.
inline constexpr const char* kTorchscript = "torchscript";

/// Name of the user's planner in a process of its own.
inline constexpr const char* kExternal = "external";

/// Names of all planners: "idm", "idm_published", "pdm", "rule_based", "rule_based_tuned",
/// "external", "torchscript".
const std::vector<std::string>& plannerNames();

/// Creates the planner `name` (one of plannerNames()). `attacker_id` is used only by idm_published,
/// which knows the attacker. Throws std::invalid_argument for an unknown name, and PlannerFileError
/// if a learned planner's file cannot be used.
PlannerUnderTest makePlanner(const std::string& name, const PlannerOptions& options,
                             const std::string& attacker_id);

}  // namespace forge
