#include "collision_forge/planner_test/trials/planner_result.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/attack/policy/adaptive_attacker.h"
#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/planners/planner_factory.h"

namespace forge {
namespace {

constexpr const char* kPublishedIdm = "idm_published";

AvoidabilitySummary summaryOf(const Avoidability& found, double now) {
  AvoidabilitySummary summary;
  summary.is_avoidable = found.isAvoidable();
  for (const Avoidance& avoidance : found.from_now) {
    summary.from_now.push_back(avoidance.manoeuvre);
  }
  if (found.last) {
    summary.last = found.last->manoeuvre;
    summary.last_after = fromNow(found.last->start, now);
    summary.off_road_share = found.last->off_road_share;
  }
  return summary;
}

AvoidabilitySummary summaryOf(const std::optional<Evasion>& evasion, double now) {
  Avoidability found;
  if (evasion) found.last = evasion->ego;
  return summaryOf(found, now);
}

RolloutOutcome drive(const PlannerCase& one, const std::string& planner,
                     const RolloutSetup& setup) {
  const PlannerUnderTest made =
      makePlanner(planner, setup.planners, one.scenario.attacker.attacker_id);
  return rollout(*made.planner, made.driving, one.scenario, setup);
}

/// Summarises the attacker's motion, verified against the ego as driven and the other agents as
/// recorded.
AttackerSummary summaryOf(const PlannerCase& one, PolicyKind policy, Background background,
                          const RolloutOutcome& outcome, const AnswerOptions& options) {
  AttackerSummary summary;
  summary.policy = policy;
  summary.phase = outcome.phase;
  summary.plans = static_cast<int>(outcome.attacker_plans.size());
  const CrashScenario& scenario = one.scenario;
  Future driven = scenario.recorded;
  // The positions of reactive agents are not kept.
  if (background != Background::kReplay) driven.agents.clear();
  driven.ego.states = toStates(outcome.driven);
  AttackerTrajectory attacker = outcome.attacker;
  const double end = outcome.driven.back().time;
  const auto after = std::find_if(attacker.points.begin(), attacker.points.end(),
                                  [=](const TrajectoryPoint& point) { return point.time >= end; });
  if (after != attacker.points.end())
    attacker.points.erase(std::next(after), attacker.points.end());
  CollisionRequest request = one.request;
  if (policy == PolicyKind::kAdaptive) request.crash.limits = kAdaptiveLimits;
  const CollisionReport report = verifyDrive(
      attacker, {scenario.snapshot, driven, request, *scenario.lanes}, options.attack.verification);
  summary.broken_limit = report.broken_limit;
  summary.touched = report.first_other_id;
  if (outcome.contact && outcome.contact->is_attacker) {
    const double off = outcome.contact->time - scenario.snapshot.now - one.request.tta;
    summary.as_asked =
        outcome.contact->type == one.request.type && std::abs(off) <= options.crash.time_tolerance;
  }
  return summary;
}

/// Returns nothing if a planner failure ends the rollout through contacts. `one.published` must be
/// set.
std::optional<bool> isPublishedHit(const PlannerCase& one, const std::string& planner,
                                   Background background, const AnswerOptions& options,
                                   const TrialOptions& trials) {
  if (planner == kPublishedIdm) return one.published->isIdmHit(trials.published_idm);
  const RolloutOutcome outcome =
      drive(one, planner, {trials, options.attack, options.crash, background, false});
  if (outcome.failure != PlannerFailure::kNone) return std::nullopt;
  return one.published->isHit(outcome.driven);
}

}  // namespace

PlannerTestResult untested(const PlannerCase& one, const std::string& status,
                           const std::string& message) {
  PlannerTestResult result;
  result.name = one.name;
  result.source = one.source;
  result.scene = one.scene;
  result.type = one.request.type;
  result.tta = one.request.tta;
  result.now = one.scenario.snapshot.now;
  result.status = status;
  result.message = message;
  return result;
}

PlannerTestResult evaluateCase(const PlannerCase& one, const AnswerOptions& options,
                               const TrialOptions& trials) {
  PlannerTestResult result = untested(one, toString(one.status.code), one.status.message);
  if (one.status.code != StatusCode::kOk) return result;
  try {
    checkScenario(one.scenario);
  } catch (const std::invalid_argument& error) {
    return untested(one, kUnfit, error.what());
  }
  const CrashScenario& scenario = one.scenario;
  result.is_strict =
      strictOutcome(scenario.attacker,
                    {scenario.snapshot, scenario.recorded, one.request, *scenario.lanes},
                    options.attack.verification)
          .meetsFullDefinitions();
  result.avoidability = summaryOf(
      findAvoidability(scenario, trials.avoidability, trials.planning.route, options.attack),
      scenario.snapshot.now);
  result.careful_drivers = driveCarefully(scenario.recorded, scenario.attacker);
  return result;
}

std::string rowName(const RowKey& key) {
  std::string name = key.planner;
  if (key.policy != PolicyKind::kFixed) name += " against adaptive";
  if (key.background == Background::kReplay) return name;
  return name + " in " + toString(key.background) + " traffic";
}

RowKey keyOf(const PlannerRow& row) { return {row.planner, row.attacker.policy, row.background}; }

std::string rowName(const PlannerRow& row) { return rowName(keyOf(row)); }

std::vector<RowKey> rowKeys(const TestPlan& plan) {
  std::vector<RowKey> keys;
  for (const std::string& planner : plan.planners) {
    for (const PolicyKind policy : plan.policies) {
      for (const Background background : plan.backgrounds) {
        keys.push_back({planner, policy, background});
      }
    }
  }
  return keys;
}

std::vector<std::string> rowNames(const TestPlan& plan) {
  std::vector<std::string> names;
  for (const RowKey& key : rowKeys(plan)) names.push_back(rowName(key));
  return names;
}

std::string pictureName(const RowKey& key, int rank) {
  std::string name = key.planner + "_" + toString(key.policy) + "_";
  if (key.background != Background::kReplay) name += std::string(toString(key.background)) + "_";
  return name + std::to_string(rank);
}

std::unique_ptr<AttackerPolicy> makeAttacker(const PlannerCase& one, PolicyKind policy,
                                             const PredictionModels& models,
                                             const AnswerOptions& options) {
  if (policy == PolicyKind::kFixed || one.request.reverses()) return nullptr;
  const CrashScenario& scenario = one.scenario;
  return std::make_unique<AdaptiveAttacker>(
      AttackerTask{scenario.snapshot, scenario.lanes, scenario.ego, one.request, one.pattern,
                   scenario.attacker, one.effort},
      AttackerSetup{std::make_shared<NetworkEgoFutures>(options.attack.ego_futures,
                                                        models.withoutScene(one.scene)),
                    options.attack, options.adaptive});
}

PlannerRow testPlanner(const PlannerCase& one, const RowKey& key, const PredictionModels& models,
                       const AnswerOptions& options, const TrialOptions& trials) {
  const auto attacker = makeAttacker(one, key.policy, models, options);
  const RolloutSetup setup{trials,         options.attack, options.crash,
                           key.background, true,           attacker.get()};
  PlannerRow row;
  row.planner = key.planner;
  row.background = key.background;
  row.outcome = drive(one, key.planner, setup);
  row.attacker = summaryOf(one, key.policy, key.background, row.outcome, options);
  if (row.outcome.contact && row.outcome.contact->is_attacker) {
    row.evasion_drive = findEvasion(one.scenario, row.outcome.driven, setup);
    row.evasion = summaryOf(row.evasion_drive, one.scenario.snapshot.now);
    const FairnessOptions& fairness = options.adaptive.fairness;
    row.is_fair = row.evasion->is_avoidable && row.evasion->last_after >= fairness.avoidable_for &&
                  (!fairness.avoidable_by ||
                   isAvoidedBy(row.outcome.careful_drivers, *fairness.avoidable_by));
  }
  if (one.published && key.policy == PolicyKind::kFixed &&
      row.outcome.failure == PlannerFailure::kNone) {
    row.published_hit = isPublishedHit(one, key.planner, key.background, options, trials);
  }
  return row;
}

void dropMotions(PlannerTestResult& result) {
  for (PlannerRow& row : result.rows) {
    row.outcome.driven.clear();
    row.outcome.others.clear();
    row.outcome.attacker = {};
    row.outcome.attacker_plans.clear();
    row.evasion_drive.reset();
  }
}

PlannerTestResult testPlanners(const PlannerCase& one, const TestPlan& plan,
                               const AnswerOptions& options, const TrialOptions& trials) {
  PlannerTestResult result = evaluateCase(one, options, trials);
  for (const std::string& name : plan.planners) {
    if (result.status == kUnfit && one.published && name == kPublishedIdm) {
      result.rows.push_back(
          {name, {}, {}, {}, {}, true, one.published->isIdmHit(trials.published_idm)});
    }
  }
  if (!result.isTested()) return result;
  for (const RowKey& key : rowKeys(plan)) {
    result.rows.push_back(testPlanner(one, key, plan.models, options, trials));
  }
  return result;
}

}  // namespace forge
