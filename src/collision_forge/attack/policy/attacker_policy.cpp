#include "collision_forge/attack/policy/attacker_policy.h"

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {

namespace {

constexpr EnumWord<AttackerPhase> kPhaseWords[] = {
    {AttackerPhase::kAttacking, "attacking"},
    {AttackerPhase::kCommitted, "committed"},
    {AttackerPhase::kDrivingOn, "driving_on"},
};

}  // namespace

namespace {

constexpr EnumWord<PolicyKind> kPolicyWords[] = {
    {PolicyKind::kFixed, "fixed"},
    {PolicyKind::kAdaptive, "adaptive"},
};

}  // namespace

const char* toString(AttackerPhase phase) { return wordOf(kPhaseWords, phase); }

std::optional<AttackerPhase> attackerPhaseFromString(const std::string& name) {
  return valueOf(kPhaseWords, name);
}

AttackerPlan firstPlan(const AttackerTrajectory& trajectory, AttackerPhase phase) {
  const double now = trajectory.points.front().time;
  return {now, now, phase, "initial plan", trajectory.points};
}

const char* toString(PolicyKind kind) { return wordOf(kPolicyWords, kind); }

std::optional<PolicyKind> policyKindFromString(const std::string& name) {
  return valueOf(kPolicyWords, name);
}

}  // namespace forge
