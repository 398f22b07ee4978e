#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/planners/planner.h"

namespace forge {

/// How often a planner is called and how the ego follows its plans.
struct Driving {
  /// s of scene time between two calls of plan(); a multiple of RolloutOptions::step.
  double interval = 0.0;
  /// True: the ego follows the plan exactly, interpolated between its points, without vehicle
  /// limits. False: the kinematic bicycle follows it.
  bool is_exact = false;
};

/// A planner with its driving settings.
struct PlannerUnderTest {
  std::unique_ptr<Planner> planner;  ///< not yet initialised; never null
  Driving driving;                   ///< as the planner requires
};

/// Name of the learned planner, which is loaded from a file.
inline constexpr const char* kTorchscript = "torchscript";

/// Name of the user's planner in a process of its own.
inline constexpr const char* kExternal = "external";

/// Names of all planners: "idm", "idm_published", "pdm", "rule_based", "rule_based_tuned",
/// "external", "torchscript".
const std::vector<std::string>& plannerNames();

/// Creates the planner `name` (one of plannerNames()). `attacker_id`: Track::id of the attacker,
/// used only by idm_published, which knows the attacker. Throws std::invalid_argument, listing the
/// known names, for an unknown name, and PlannerFileError if a learned planner's file cannot be
/// used. The process of "external" starts later, in initialize().
PlannerUnderTest makePlanner(const std::string& name, const PlannerOptions& options,
                             const std::string& attacker_id);

}  // namespace forge
