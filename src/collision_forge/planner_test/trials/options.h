#pragma once

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/contact_judgement.h"
#include "collision_forge/planner_test/trials/nuplan_score.h"

namespace forge {

/// Options of rollout(): config/planners.yaml, section rollout, where the source of its key stands.
struct RolloutOptions {
  double step = 0.0;                                      ///< s between two states
  double hard_braking = PdmComfortOptions().max_braking;  ///< m/s2; stronger braking counts as hard
  FaultOptions fault;
};

/// Options of forge test --until-hit: config/planners.yaml, section until_hit.
struct UntilHitOptions {
  int tries = 0;                  ///< number of requests
  double min_impact_speed = 0.0;  ///< m/s; softer hits are ignored
};

/// Options of forge sweep: config/planners.yaml, section sweep, where the reasons stand. A swept
/// value of a field that is a range requests [value - tolerance, value + tolerance].
struct SweepOptions {
  /// Half the width of the requested range, in the unit of the field, by its name.
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
  RolloutOptions rollout;
  NuplanScoreOptions nuplan_score;
  AvoidabilityOptions avoidability;
  UntilHitOptions until_hit;
  SweepOptions sweep;
};

/// Reads all of planners.yaml; `limits` are the ego's. Throws ConfigError for a missing, unknown or
/// malformed key.
void readOptions(Section& file, TrialOptions& options, const VehicleLimits& limits);

}  // namespace forge
