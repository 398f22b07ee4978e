#include "collision_forge/study/evaluation/request_evaluation.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "collision_forge/attack/policy/adaptive_answer.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/io/answers/allowed_requests.h"
#include "collision_forge/study/evaluation/outcome_row.h"

namespace forge {
namespace {

const std::vector<std::string> kBaselines = {"constant_velocity", "nominal"};

std::vector<RequestEvaluator::MethodRow> methodRows(const EvaluationPlan& plan) {
  const bool is_baseline =
      std::find(kBaselines.begin(), kBaselines.end(), plan.method) != kBaselines.end();
  if (is_baseline) return {};
  const int seeds = plan.is_seeded ? plan.seeds : 1;
  std::vector<RequestEvaluator::MethodRow> rows;
  if (plan.mode == Mode::kAdaptive) rows.push_back({"adaptive", Mode::kAdaptive, seeds});
  rows.push_back({plan.method, plan.mode == Mode::kReplay ? Mode::kReplay : Mode::kHistory, seeds});
  if (plan.is_seeded && plan.mode != Mode::kReplay) {
    rows.push_back({"replay", Mode::kReplay, seeds});
  }
  return rows;
}

/// Returns the options with the plan's limits and plausibility and without a minimum confidence.
StudyOptions withPlan(StudyOptions study, const EvaluationPlan& plan) {
  study.crash.min_confidence = 0.0;
  study.crash.limits = plan.limits;
  study.crash.believable = plan.believable;
  return study;
}

/// Returns the request for baselines, which model neither steering nor lanes.
CollisionRequest asBaseline(CollisionRequest request) {
  request.crash.limits = LimitSet::kStrict;
  request.crash.believable = false;
  return request;
}

std::vector<MethodMaker> baselinesOf(const MethodRegistry& methods, const AttackOptions& options,
                                     const PredictionModels& models) {
  std::vector<MethodMaker> makers;
  for (const std::string& name : kBaselines) makers.emplace_back(name, methods, options, models);
  return makers;
}

/// The inputs to verify the attack of a method.
struct RequestCase {
  const CollisionRequest& request;
  const Moment& moment;
  const AttackOptions& options;

  StrictOutcome outcomeOf(const AttackerTrajectory& trajectory) const {
    return strictOutcome(trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes},
                         options.verification);
  }
};

/// Returns the reason why no method can solve the request, or kOk.
Status checkCase(const RequestCase& request_case) {
  const auto& [request, moment, options] = request_case;
  const Status status = checkRequest(request, moment.snapshot, options.prediction);
  if (status.code != StatusCode::kOk) return status;
  if (!stateAt(moment.recorded->ego, moment.snapshot.now + request.tta)) {
    return {StatusCode::kBeyondRecording, "the recording of the ego ends before t0 + TTA"};
  }
  return {};
}

void judge(const RequestCase& request_case, const StrictOutcome& outcome, ResultRow& row) {
  describeOutcome(outcome, request_case.moment.snapshot.now, row);
  if (outcome.report.contact) row.request->believable = outcome.report.believable();
}

void refuse(const Status& status, ResultRow& row) {
  row.status = toString(status.code);
  row.note = status.message;
}

ResultRow emptyRow(const std::string& name, const std::string& method, const SceneRequest& asked) {
  ResultRow row;
  row.name = name;
  row.method = method;
  row.scene = asked.scene;
  row.type = asked.request.type;
  row.tta = asked.request.tta;
  row.seed = asked.request.seed;
  row.status = toString(StatusCode::kOk);
  row.meets.assign(measuresOf(Protocol::kStrict).size(), false);
  row.request.emplace();
  return row;
}

std::vector<std::string> possibleAttackers(const RequestCase& request_case) {
  if (request_case.request.attacker) return {*request_case.request.attacker};
  std::vector<std::string> ids;
  const Snapshot& snapshot = request_case.moment.snapshot;
  for (const Track& agent : snapshot.agents) {
    if (isCandidate(agent, snapshot, request_case.options.prediction)) ids.push_back(agent.id);
  }
  return ids;
}

/// Ranks the outcome of a baseline; higher is better.
int rankOf(const StrictOutcome& outcome) {
  return outcome.meetsFullDefinitions() ? 3
         : outcome.meetsAngleBands()    ? 2
         : outcome.report.contact       ? 1
                                        : 0;
}

void evaluateBaseline(const AttackMethod& method, const RequestCase& request_case, ResultRow& row) {
  CollisionRequest request = request_case.request;
  std::optional<AttackerTrajectory> best;
  StrictOutcome best_outcome;
  for (const std::string& attacker : possibleAttackers(request_case)) {
    request.attacker = attacker;
    AttackerTrajectory trajectory = attempt(method, request_case.moment, request).trajectory;
    const StrictOutcome outcome = request_case.outcomeOf(trajectory);
    if (best && rankOf(outcome) <= rankOf(best_outcome)) continue;
    best = std::move(trajectory);
    best_outcome = outcome;
  }
  if (best) {
    judge(request_case, best_outcome, row);
  } else {
    refuse({StatusCode::kNoCandidate,
            "no vehicle within candidate_radius was observed at t0 and in the frame before"},
           row);
  }
}

void judgeAnswer(const RequestCase& request_case, const Attack& answer, ResultRow& row) {
  if (answer.status.code == StatusCode::kOk) {
    judge(request_case, request_case.outcomeOf(answer.trajectory), row);
  } else {
    refuse(answer.status, row);
  }
}

/// An attack with the wall-clock time of its search.
struct TimedAnswer {
  Attack answer;
  double milliseconds = 0.0;
};

TimedAnswer evaluateMethod(const AttackMethod& method, const RequestCase& request_case,
                           const CollisionRequest& request, ResultRow& row) {
  const auto begin = std::chrono::steady_clock::now();
  Attack answer = attempt(method, request_case.moment, request);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  judgeAnswer(request_case, answer, row);
  return {std::move(answer), time.count()};
}

}  // namespace

std::vector<std::string> requestRowMethods(const EvaluationPlan& plan) {
  std::vector<std::string> names = kBaselines;
  for (const auto& row : methodRows(plan)) names.push_back(row.name);
  return names;
}

std::size_t rowsPerRequest(const EvaluationPlan& plan) {
  std::size_t count = kBaselines.size();
  for (const auto& row : methodRows(plan)) {
    count += static_cast<std::size_t>(row.seeds);
  }
  return count;
}

RequestEvaluator::RequestEvaluator(SceneSource& scenes, const StudyOptions& study,
                                   const PredictionModels& models, const MethodRegistry& methods,
                                   const EvaluationPlan& plan)
    : scenes_(scenes),
      study_(withPlan(study, plan)),
      plan_(plan),
      rows_(methodRows(plan)),
      baselines_(baselinesOf(methods, study.attack, models)),
      method_(plan.method, methods, study.attack, models) {
  if (plan.protocol != Protocol::kStrict) {
    throw std::invalid_argument("protocol = " + std::string(toString(plan.protocol)) +
                                " is not supported for requests; use strict");
  }
  if (!rows_.empty() && plan.is_seeded != method_.isSeeded()) {
    throw std::invalid_argument("is_seeded of the plan contradicts the method " + plan.method);
  }
}

EvaluatedRequest RequestEvaluator::evaluate(const std::string& name,
                                            const SceneRequest& asked) const {
  const auto recording = scenes_.at(asked.scene);
  const auto found = momentAt(*recording, asked.now, study_.attack.prediction.history_frames);
  const Moment* moment = std::get_if<Moment>(&found);
  CollisionRequest request = asked.request;
  request.mode = plan_.mode == Mode::kReplay ? Mode::kReplay : Mode::kHistory;
  request.crash = study_.crash;
  Status status;
  if (moment) {
    status = checkCase({request, *moment, study_.attack});
  } else {
    status = std::get<Status>(found);
  }
  std::optional<bool> road_allows;
  if (moment) road_allows = roadAllowsRequest(asked, *recording, study_);
  EvaluatedRequest evaluated;
  const auto addRow = [&](const std::string& method) -> ResultRow& {
    ResultRow& row = evaluated.rows.emplace_back(emptyRow(name, method, asked));
    row.request->road_allows = road_allows;
    if (status.code != StatusCode::kOk) refuse(status, row);
    return row;
  };
  for (const MethodMaker& baseline : baselines_) {
    ResultRow& row = addRow(baseline.name());
    if (status.code != StatusCode::kOk) continue;
    const CollisionRequest as_baseline = asBaseline(request);
    evaluateBaseline(*baseline.makeWithoutScene(asked.scene), {as_baseline, *moment, study_.attack},
                     row);
  }
  const auto method = method_.makeWithoutScene(asked.scene);
  for (const MethodRow& kind : rows_) {
    for (int seed = 0; seed < kind.seeds; ++seed) {
      ResultRow& row = addRow(kind.name);
      row.seed += static_cast<std::uint64_t>(seed);
      if (status.code != StatusCode::kOk) continue;
      CollisionRequest seeded = request;
      seeded.mode = kind.mode;
      seeded.seed = row.seed;
      seeded.crash.rules = TypeRules::kFull;
      const RequestCase request_case{request, *moment, study_.attack};
      Attack answer;
      if (kind.mode == Mode::kAdaptive) {
        AdaptiveDrive adaptive = requestAdaptively(
            *method, *moment, recording->scene,
            egoVehicleOf(recording->scene, study_.ego_vehicle.center_offset), seeded,
            {method_.egoFuturesWithoutScene(asked.scene), study_.attack, study_.adaptive});
        for (const double time : adaptive.milliseconds) {
          evaluated.times.push_back({"adaptive, per update step", time});
        }
        answer = std::move(adaptive.attack);
        judgeAnswer(request_case, answer, row);
      } else {
        TimedAnswer timed = evaluateMethod(*method, request_case, seeded, row);
        if (method_.isSeeded()) evaluated.times.push_back({kind.name, timed.milliseconds});
        answer = std::move(timed.answer);
      }
      if (answer.status.code != StatusCode::kOk) continue;
      if (method_.isSeeded()) row.confidence = answer.report.confidence;
      row.request->attacker = answer.trajectory.attacker_id;
      row.request->attacker_class = answer.trajectory.agent_class;
    }
  }
  return evaluated;
}

}  // namespace forge
