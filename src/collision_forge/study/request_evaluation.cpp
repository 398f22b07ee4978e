#include "collision_forge/study/request_evaluation.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "collision_forge/attack/request_check.h"
#include "collision_forge/study/baselines.h"
#include "collision_forge/study/strict.h"

namespace forge {
namespace {

const char* const kConstantVelocity = "constant_velocity";
const char* const kNominal = "nominal";
const char* const kSearch = "search";
const char* const kNetwork = "network";
const char* const kNetworkSearch = "network+search";

/// A search of the plan.
struct SearchKind {
  std::string name;
  TypeRules rules;
  bool knows_future;
};

std::vector<SearchKind> searchesOf(const EvaluationPlan& plan) {
  if (plan.method != kSearch && plan.method != kNetworkSearch) return {};
  const bool is_replay = plan.mode == Mode::kReplay;
  std::vector<SearchKind> kinds = {
      {plan.method + "_angle_bands", TypeRules::kAngle, is_replay},
      {plan.method + "_full_definitions", TypeRules::kFull, is_replay}};
  if (!is_replay) {
    kinds.push_back({"replay_angle_bands", TypeRules::kAngle, true});
    kinds.push_back({"replay_full_definitions", TypeRules::kFull, true});
  }
  return kinds;
}

/// The configuration that a column's search runs with; what comes is measured, whatever the
/// confidence.
Config searchedWith(Config config, TypeRules rules) {
  config.attack.type_rules = rules;
  config.attack.search.min_confidence = 0.0;
  return config;
}

/// What every method is held against.
struct RequestCase {
  const SceneRequest& asked;
  const IndexedScene& indexed;
  const RecordedMoment& moment;
  const Config& config;

  StrictOutcome outcomeOf(const AttackerTrajectory& trajectory) const {
    return strictOutcome(trajectory,
                         {moment.snapshot, moment.recorded, asked.request, *indexed.lanes},
                         config.attack);
  }
};

/// Why no method can answer, if so.
Status checkCase(const RequestCase& request_case) {
  const auto& [asked, indexed, moment, config] = request_case;
  if (moment.status.code != StatusCode::kOk) return moment.status;
  const Status status = checkRequest(asked.request, moment.snapshot, config.attack.prediction);
  if (status.code != StatusCode::kOk) return status;
  if (!stateAt(moment.recorded.ego, asked.now + asked.request.tta)) {
    return {StatusCode::kBeyondRecording, "the ego's recording ends before the impact"};
  }
  return {};
}

/// What the agent itself drove, if it was recorded until then without a gap.
std::optional<AttackerTrajectory> ownMotion(const std::string& id, const Future& recorded,
                                            double until) {
  const auto track = std::find_if(recorded.agents.begin(), recorded.agents.end(),
                                  [&](const Track& agent) { return agent.id == id; });
  if (track == recorded.agents.end()) return std::nullopt;
  AttackerTrajectory own{id, track->agent_class, track->size, {}};
  for (const AgentState& state : track->states) {
    const bool has_gap = !own.points.empty() &&
                         !stateAt(*track, 0.5 * (own.points.back().time + state.time)).has_value();
    if (has_gap) return std::nullopt;
    own.points.push_back({state.time, state.pose, 0.0, 0.0, 0.0});
    if (state.time >= until) return own;
  }
  return std::nullopt;
}

void judge(const RequestCase& request_case, const AttackerTrajectory& trajectory,
           const StrictOutcome& outcome, ResultRow& row) {
  describeOutcome(outcome, request_case.moment.snapshot.now, row);
  if (!outcome.report.contact) return;
  const auto own =
      ownMotion(trajectory.attacker_id, request_case.moment.recorded, outcome.report.contact_time);
  if (!own) return;
  row.own_off_road_share = offRoadShare(*own, outcome.report, *request_case.indexed.lanes,
                                        request_case.config.attack.verification);
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
  return row;
}

std::vector<std::string> possibleAttackers(const RequestCase& request_case) {
  if (request_case.asked.request.attacker) return {*request_case.asked.request.attacker};
  std::vector<std::string> ids;
  const Snapshot& snapshot = request_case.moment.snapshot;
  for (const Track& agent : snapshot.agents) {
    if (isCandidate(agent, snapshot, request_case.config.attack.prediction)) {
      ids.push_back(agent.id);
    }
  }
  return ids;
}

AttackerTrajectory baseline(const std::string& method, const std::string& attacker,
                            const RequestCase& request_case, Mode mode) {
  const auto& [asked, indexed, moment, config] = request_case;
  if (method == kConstantVelocity) {
    return constantVelocityAttacker(attacker, moment.snapshot, asked.request.tta, config.attack);
  }
  CollisionRequest request = asked.request;
  request.mode = mode;
  return nominalAttacker(attacker, moment.snapshot, moment.recorded, request,
                         config.evaluation.nominal, config.attack);
}

/// How much of what is asked for an outcome meets; more is better.
int rankOf(const StrictOutcome& outcome) {
  return outcome.meetsFullDefinitions() ? 3
         : outcome.meetsAngleBands()    ? 2
         : outcome.report.contact       ? 1
                                        : 0;
}

void evaluateBaseline(const RequestCase& request_case, Mode mode, ResultRow& row) {
  std::optional<AttackerTrajectory> best;
  StrictOutcome best_outcome;
  for (const std::string& attacker : possibleAttackers(request_case)) {
    AttackerTrajectory trajectory = baseline(row.method, attacker, request_case, mode);
    const StrictOutcome outcome = request_case.outcomeOf(trajectory);
    if (best && rankOf(outcome) <= rankOf(best_outcome)) continue;
    best = std::move(trajectory);
    best_outcome = outcome;
  }
  if (best) {
    judge(request_case, *best, best_outcome, row);
  } else {
    refuse({StatusCode::kNoCandidate,
            "no vehicle within candidate_radius, seen now and in the frame before"},
           row);
  }
}

/// One quintic to the likeliest pattern.
void evaluatePattern(const RequestCase& request_case, Mode mode, const Foresight& foresight,
                     ResultRow& row) {
  const auto& [asked, indexed, moment, config] = request_case;
  CollisionRequest request = asked.request;
  request.mode = mode;
  const PatternPrediction prediction =
      foresight.withoutScene(asked.scene)
          .patterns(config.attack)
          ->predict(moment.snapshot, *indexed.lanes, request,
                    mode == Mode::kReplay ? &moment.recorded : nullptr);
  if (prediction.status.code != StatusCode::kOk) {
    refuse(prediction.status, row);
    return;
  }
  const AttackerTrajectory trajectory =
      patternAttacker(prediction.patterns.front(), moment.snapshot, request.tta, config.attack);
  judge(request_case, trajectory, request_case.outcomeOf(trajectory), row);
}

void evaluateAnswer(const RequestCase& request_case, const Status& status,
                    const Realization& answer, ResultRow& row) {
  if (status.code != StatusCode::kOk) {
    refuse(status, row);
    return;
  }
  judge(request_case, answer.trajectory, request_case.outcomeOf(answer.trajectory), row);
  row.confidence = answer.report.confidence;
}

}  // namespace

const std::vector<std::string>& requestMethods() {
  static const std::vector<std::string> methods = {kConstantVelocity, kNominal, kSearch, kNetwork,
                                                   kNetworkSearch};
  return methods;
}

std::vector<std::string> requestRowMethods(const EvaluationPlan& plan) {
  std::vector<std::string> methods = {kConstantVelocity, kNominal};
  if (plan.method == kNetwork) methods.emplace_back(kNetwork);
  for (const SearchKind& kind : searchesOf(plan)) methods.emplace_back(kind.name);
  return methods;
}

std::size_t rowsPerRequest(const EvaluationPlan& plan) {
  const std::size_t single = plan.method == kNetwork ? 3 : 2;
  return single + searchesOf(plan).size() * static_cast<std::size_t>(plan.seeds);
}

RequestEvaluator::RequestEvaluator(SceneSource& scenes, const Config& config,
                                   const Foresight& foresight, const EvaluationPlan& plan)
    : scenes_(scenes),
      foresight_(needsNetworks(plan.method) ? foresight : foresight.withoutNetwork()),
      plan_(plan),
      angle_config_(searchedWith(config, TypeRules::kAngle)),
      full_config_(searchedWith(config, TypeRules::kFull)),
      angle_answerer_(scenes, angle_config_, foresight_),
      full_answerer_(scenes, full_config_, foresight_) {
  checkNetworks(plan.method, foresight);
  const auto& methods = requestMethods();
  if (plan.protocol != Protocol::kStrict ||
      std::find(methods.begin(), methods.end(), plan.method) == methods.end()) {
    throw std::invalid_argument("requests are not evaluated by the " +
                                std::string(toString(plan.protocol)) + " protocol, method \"" +
                                plan.method + "\"");
  }
}

EvaluatedRequest RequestEvaluator::evaluate(const std::string& name,
                                            const SceneRequest& asked) const {
  const auto indexed = scenes_.at(asked.scene);
  const RecordedMoment moment =
      momentAt(indexed->scene, asked.now, full_config_.attack.prediction.history_frames);
  const RequestCase request_case{asked, *indexed, moment, full_config_};
  const Status status = checkCase(request_case);
  EvaluatedRequest evaluated;
  for (const char* method : {kConstantVelocity, kNominal}) {
    ResultRow& row = evaluated.rows.emplace_back(emptyRow(name, method, asked));
    if (status.code == StatusCode::kOk) {
      evaluateBaseline(request_case, plan_.mode, row);
    } else {
      refuse(status, row);
    }
  }
  if (plan_.method == kNetwork) {
    ResultRow& row = evaluated.rows.emplace_back(emptyRow(name, kNetwork, asked));
    if (status.code == StatusCode::kOk) {
      evaluatePattern(request_case, plan_.mode, foresight_, row);
    } else {
      refuse(status, row);
    }
  }
  for (const SearchKind& kind : searchesOf(plan_)) {
    for (int seed = 0; seed < plan_.seeds; ++seed) {
      SceneRequest seeded = asked;
      seeded.request.mode = kind.knows_future ? Mode::kReplay : Mode::kHistory;
      seeded.request.seed += static_cast<std::uint64_t>(seed);
      const TimedAnswer answer = search(kind.rules, seeded, *indexed);
      evaluated.times.push_back({kind.name, answer.milliseconds});
      ResultRow& row = evaluated.rows.emplace_back(emptyRow(name, kind.name, seeded));
      evaluateAnswer(request_case, status.code == StatusCode::kOk ? answer.answer.status : status,
                     answer.answer, row);
    }
  }
  return evaluated;
}

RequestEvaluator::TimedAnswer RequestEvaluator::search(TypeRules rules, const SceneRequest& asked,
                                                       const IndexedScene& indexed) const {
  const RequestAnswerer& answerer = rules == TypeRules::kFull ? full_answerer_ : angle_answerer_;
  const auto begin = std::chrono::steady_clock::now();
  Realization answer = answerer.answer(asked, indexed).answer;
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
  return {std::move(answer), time.count()};
}

}  // namespace forge
