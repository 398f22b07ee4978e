#include "collision_forge/attack/policy/attacker_policy.h"

namespace forge {

const char* toString(AttackerPhase phase) {
  switch (phase) {
    case AttackerPhase::kAttacking:
      return "attacking";
    case AttackerPhase::kCommitted:
      return "committed";
    case AttackerPhase::kDrivingOn:
      break;
  }
  return "driving_on";
}

std::optional<AttackerPhase> attackerPhaseFromString(const std::string& name) {
  for (const AttackerPhase phase :
       {AttackerPhase::kAttacking, AttackerPhase::kCommitted, AttackerPhase::kDrivingOn}) {
    if (name == toString(phase)) return phase;
  }
  return std::nullopt;
}

AttackerPlan firstPlan(const AttackerTrajectory& trajectory, AttackerPhase phase) {
  const double now = trajectory.points.front().time;
  return {now, now, phase, "sets out", trajectory.points};
}

const char* toString(PolicyKind kind) { return kind == PolicyKind::kFixed ? "fixed" : "adaptive"; }

std::optional<PolicyKind> policyKindFromString(const std::string& name) {
  for (const PolicyKind kind : {PolicyKind::kFixed, PolicyKind::kAdaptive}) {
    if (name == toString(kind)) return kind;
  }
  return std::nullopt;
}

}  // namespace forge
