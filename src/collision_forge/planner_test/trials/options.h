#pragma once

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/contact_judgement.h"
#include "collision_forge/planner_test/trials/nuplan_score.h"

namespace forge {

/// Options of rollout(): config/planners.yaml, section rollout, where the source of its key stands.
struct RolloutOptions {
  double step = 0.0;                                      ///< s between two states of a rollout
  double hard_braking = PdmComfortOptions().max_braking;  ///< m/s2; stronger braking counts as hard
  FaultOptions fault;                                     ///< of the ego in a contact
};

/// Options of forge test --until-hit: config/planners.yaml, section until_hit.
struct UntilHitOptions {
  int tries = 0;                  ///< number of requests to draw
  double min_impact_speed = 0.0;  ///< m/s; softer hits are no weakness
};

/// Options of forge sweep: config/planners.yaml, section sweep, where the reasons stand. A swept
/// value of a field that is a range requests [value - tolerance, value + tolerance].
struct SweepOptions {
  /// Half the width of the requested range, in the unit of the field, by SweepParameter::name.
  std::map<std::string, double> tolerances;
};

/// All options of config/planners.yaml: the planners and the tests.
struct TrialOptions : PlannerOptions {
  /// Drives other agents with Background::kIdm: `idm` of the file, whatever planner or variant is
  /// tested.
  IdmOptions traffic;
  /// Drives other agents with Background::kModel: `torchscript` of the file with the model's file,
  /// which the command line names.
  TorchscriptOptions traffic_model;
  RolloutOptions rollout;            ///< section rollout
  NuplanScoreOptions nuplan_score;   ///< no section
  AvoidabilityOptions avoidability;  ///< section avoidability
  UntilHitOptions until_hit;         ///< section until_hit
  SweepOptions sweep;                ///< section sweep
};

/// Reads all of planners.yaml; `limits`: the ego's strict limits. `traffic_model.file` stays empty.
/// Throws ConfigError for a missing, unknown, malformed or out-of-range value, and if an interval
/// between calls of a planner is not a multiple of rollout.step.
void readOptions(Section& file, TrialOptions& options, const VehicleLimits& limits);

}  // namespace forge
