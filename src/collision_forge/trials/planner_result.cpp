#include "collision_forge/trials/planner_result.h"

#include <cmath>

#include "collision_forge/planners/planner_factory.h"
#include "collision_forge/study/clip_attackers.h"
#include "collision_forge/study/published.h"
#include "collision_forge/study/strict.h"
#include "collision_forge/trials/published_planner.h"

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

RolloutOutcome drive(const PlannerCase& one, const std::string& planner, Background background,
                     bool ends_at_contact, const StudyOptions& study, const TrialOptions& trials) {
  const PlannerUnderTest made = makePlanner(planner, trials, one.scenario.attacker.attacker_id);
  return rollout(*made.planner, made.driving, one.scenario,
                 {trials, study.attack, study.crash.types, background, ends_at_contact});
}

bool isPublishedIdmHit(const CollideClip& clip, const StudyOptions& study,
                       const TrialOptions& trials) {
  const PublishedOptions& protocol = study.evaluation.published;
  std::vector<Pose2> ego;
  for (const auto& step : publishedIdmDrive(clip, trials.published_idm, protocol)) {
    ego.push_back(step.pose);
  }
  return publishedOutcome(clip, recordedFrames(clip), ego, protocol).isHit();
}

/// Empty where a failure ends the drive that goes on after a contact.
std::optional<bool> isPublishedHit(const PlannerCase& one, const std::string& planner,
                                   Background background, const StudyOptions& study,
                                   const TrialOptions& trials) {
  if (planner == kPublishedIdm) return isPublishedIdmHit(*one.clip, study, trials);
  const RolloutOutcome outcome = drive(one, planner, background, false, study, trials);
  if (outcome.failure != PlannerFailure::kNone) return std::nullopt;
  const CollideClip driven = withEgo(*one.clip, outcome.driven);
  return publishedOutcome(driven, recordedFrames(driven), study.evaluation.published).isHit();
}

}  // namespace

double fromNow(double time, double now) { return std::round((time - now) * 1e6) / 1e6; }

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

PlannerTestResult judgeCase(const PlannerCase& one, const StudyOptions& study,
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
                    study.attack.verification)
          .meetsFullDefinitions();
  result.avoidability = summaryOf(
      findAvoidability(scenario, trials.avoidability, trials.planning.route, study.attack),
      scenario.snapshot.now);
  return result;
}

PlannerRow testPlanner(const PlannerCase& one, const std::string& planner, Background background,
                       const StudyOptions& study, const TrialOptions& trials) {
  PlannerRow row{planner, drive(one, planner, background, true, study, trials), {}};
  row.outcome.driven.clear();
  if (one.clip && row.outcome.failure == PlannerFailure::kNone) {
    row.published_hit = isPublishedHit(one, planner, background, study, trials);
  }
  return row;
}

PlannerTestResult testPlanners(const PlannerCase& one, const std::vector<std::string>& planners,
                               Background background, const StudyOptions& study,
                               const TrialOptions& trials) {
  PlannerTestResult result = judgeCase(one, study, trials);
  for (const std::string& name : planners) {
    if (result.status == kUnfit && one.clip && name == kPublishedIdm) {
      result.rows.push_back({name, {}, isPublishedIdmHit(*one.clip, study, trials)});
    }
  }
  if (!result.isTested()) return result;
  for (const std::string& name : planners) {
    result.rows.push_back(testPlanner(one, name, background, study, trials));
  }
  return result;
}

}  // namespace forge
