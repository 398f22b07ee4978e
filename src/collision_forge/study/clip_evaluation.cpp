#include "collision_forge/study/clip_evaluation.h"

#include <stdexcept>

#include "collision_forge/attack/generator.h"
#include "collision_forge/data/collide_scene.h"
#include "collision_forge/study/baselines.h"
#include "collision_forge/study/published.h"
#include "collision_forge/study/published_search.h"
#include "collision_forge/study/strict.h"

namespace forge {
namespace {

const char* const kSearch = "search";
const char* const kPublishedSearch = "published_search";
const char* const kNetwork = "network";
const std::string kWithNetwork = "network+";  // before the name of a search

/// The search without the networks.
std::string withoutNetwork(const std::string& method) {
  return method.rfind(kWithNetwork, 0) == 0 ? method.substr(kWithNetwork.size()) : method;
}

bool isSearch(const std::string& method) {
  return withoutNetwork(method) == kSearch || withoutNetwork(method) == kPublishedSearch;
}

/// What a method answers in one clip.
struct Answer {
  Status status;
  AttackerTrajectory trajectory;  ///< these two with kOk only
  std::vector<Pose2> frames;      ///< the attacker's pose in every frame of the clip
  std::optional<double> confidence;
};

/// What may be known of a clip's scene.
Foresight foresightOf(const Foresight& foresight, const CollideClip& clip,
                      const EvaluationPlan& plan) {
  if (!plan.seen_scenes) return foresight.withoutScene(clip.scene);
  return {foresight.speeds, foresight.network, clip.type};
}

/// A clip made ready for all methods.
class ClipCase {
 public:
  ClipCase(const CollideClip& clip, const LaneIndex& lanes, std::shared_ptr<const LaneMap> map,
           const Foresight& foresight, const Config& config, const EvaluationPlan& plan)
      : clip_(clip),
        lanes_(lanes),
        config_(config),
        angle_rules_(withAngleRules(config.attack)),
        foresight_(foresightOf(foresight, clip, plan)),
        scene_(toScene(clip, config.evaluation.collide, std::move(map))),
        snapshot_(snapshotAt(scene_, clip.now(), config.attack.prediction.history_frames)),
        recorded_(recordedFuture(scene_, clip.now())),
        request_(requestOf(clip, plan.mode, config.attack.prediction.min_tta)) {
    // What comes is measured, whatever the confidence.
    angle_rules_.search.min_confidence = 0.0;
  }

  Answer answer(const std::string& method, std::uint64_t seed) const {
    const BoxSize& box = config_.evaluation.collide.box;
    const SearchOptions& search_options = config_.attack.search;
    if (method == "recorded") {
      return {{}, recordedAttacker(clip_, box, search_options), recordedFrames(clip_), {}};
    }
    if (method == "constant_velocity") {
      return driven(constantVelocityAttacker(clip_, box, search_options));
    }
    if (method == "nominal") {
      return driven(nominalAttacker(clip_.attacker_id, snapshot_, recorded_, request_,
                                    config_.evaluation.nominal, config_.attack));
    }
    const Foresight foresight = needsNetworks(method) ? foresight_ : foresight_.withoutNetwork();
    if (method == kNetwork) return nominalPattern(foresight);
    if (withoutNetwork(method) == kSearch) return search(foresight, seed);
    if (withoutNetwork(method) == kPublishedSearch) return publishedSearch(foresight, seed);
    throw std::invalid_argument("unknown method \"" + method + "\"");
  }

  void judgeAsPublished(const Answer& answer, ResultRow& row) const {
    const PublishedOutcome outcome =
        publishedOutcome(clip_, answer.frames, config_.evaluation.published);
    row.meets = {outcome.isHit(), outcome.similar};
    if (outcome.event == PublishedOutcome::Event::kNone) return;
    const double frame =
        static_cast<double>(outcome.step) / config_.evaluation.published.steps_per_interval;
    row.contact_after = kCollideFrameInterval * (frame - kCollideNowFrame);
    if (outcome.isHit()) {
      row.relative_heading = outcome.relative_heading;
    } else {
      const bool is_ego = outcome.event == PublishedOutcome::Event::kEgoOther;
      row.note = (is_ego ? "ego touches " : "attacker touches ") + outcome.other_id;
    }
  }

  void judgeStrictly(const Answer& answer, ResultRow& row) const {
    describeOutcome(
        strictOutcome(answer.trajectory, {snapshot_, recorded_, request_, lanes_}, config_.attack),
        clip_.now(), row);
    row.confidence = answer.confidence;
  }

 private:
  Answer driven(AttackerTrajectory trajectory) const {
    std::vector<Pose2> frames = framesOf(clip_, trajectory);
    return {{}, std::move(trajectory), std::move(frames), {}};
  }

  Answer nominalPattern(const Foresight& foresight) const {
    const PatternPrediction prediction =
        foresight.patterns(angle_rules_)
            ->predict(snapshot_, lanes_, request_,
                      request_.mode == Mode::kReplay ? &recorded_ : nullptr);
    if (prediction.status.code != StatusCode::kOk) return {prediction.status, {}, {}, {}};
    return driven(
        patternAttacker(prediction.patterns.front(), snapshot_, request_.tta, config_.attack));
  }

  Answer search(const Foresight& foresight, std::uint64_t seed) const {
    CollisionRequest request = request_;
    request.seed = seed;
    const auto predictor = foresight.patterns(angle_rules_);
    Realization found =
        generateCollision(request, snapshot_, lanes_, &recorded_, *predictor, angle_rules_);
    if (found.status.code != StatusCode::kOk) return {found.status, {}, {}, {}};
    Answer answer = driven(std::move(found.trajectory));
    answer.confidence = found.report.confidence;
    return answer;
  }

  Answer publishedSearch(const Foresight& foresight, std::uint64_t seed) const {
    CollisionRequest request = request_;
    request.seed = seed;
    return driven(publishedSearchAttacker(clip_, snapshot_, recorded_, request, lanes_,
                                          foresight.egoFutures(config_.attack.ego_futures),
                                          config_.attack, config_.evaluation));
  }

  const CollideClip& clip_;
  const LaneIndex& lanes_;
  const Config& config_;
  AttackOptions angle_rules_;
  Foresight foresight_;
  Scene scene_;
  Snapshot snapshot_;
  Future recorded_;
  CollisionRequest request_;
};

ResultRow judge(const ClipCase& clip_case, const CollideClip& clip, const EvaluationPlan& plan,
                const std::string& method, std::uint64_t seed) {
  const Answer answer = clip_case.answer(method, seed);
  ResultRow row;
  row.name = clip.name;
  row.scene = clip.scene;
  row.type = clip.type;
  row.tta = clip.nominalTta();
  row.method = method;
  row.seed = seed;
  row.status = toString(answer.status.code);
  row.meets.assign(measuresOf(plan.protocol).size(), false);
  if (answer.status.code != StatusCode::kOk) {
    row.note = answer.status.message;
  } else if (plan.protocol == Protocol::kPublished) {
    clip_case.judgeAsPublished(answer, row);
  } else {
    clip_case.judgeStrictly(answer, row);
  }
  return row;
}

/// Seeds matter to a search alone.
int seedsOf(const std::string& method, const EvaluationPlan& plan) {
  return isSearch(method) ? plan.seeds : 1;
}

}  // namespace

const std::vector<std::string>& evaluationMethods() {
  static const std::vector<std::string> methods = {"recorded",
                                                   "constant_velocity",
                                                   "nominal",
                                                   kSearch,
                                                   kPublishedSearch,
                                                   kNetwork,
                                                   kWithNetwork + kSearch,
                                                   kWithNetwork + kPublishedSearch};
  return methods;
}

bool needsNetworks(const std::string& method) {
  return method == kNetwork || method.rfind(kWithNetwork, 0) == 0;
}

void checkNetworks(const std::string& method, const Foresight& foresight) {
  if (needsNetworks(method) && !foresight.network) {
    throw std::invalid_argument("method " + method +
                                ": pattern_network in models.yaml names no file");
  }
}

std::vector<std::string> methodsOf(const EvaluationPlan& plan) {
  std::vector<std::string> methods = {"recorded", "constant_velocity", "nominal"};
  if (isSearch(plan.method)) methods.push_back(withoutNetwork(plan.method));
  if (needsNetworks(plan.method)) methods.push_back(plan.method);
  return methods;
}

std::size_t rowsPerClip(const EvaluationPlan& plan) {
  std::size_t rows = 0;
  for (const std::string& method : methodsOf(plan)) {
    rows += static_cast<std::size_t>(seedsOf(method, plan));
  }
  return rows;
}

std::vector<ResultRow> evaluateClip(const CollideClip& clip, const LaneIndex& lanes,
                                    std::shared_ptr<const LaneMap> map, const Foresight& foresight,
                                    const Config& config, const EvaluationPlan& plan) {
  checkNetworks(plan.method, foresight);
  const ClipCase clip_case(clip, lanes, std::move(map), foresight, config, plan);
  std::vector<ResultRow> rows;
  for (const std::string& method : methodsOf(plan)) {
    for (int seed = 0; seed < seedsOf(method, plan); ++seed) {
      rows.push_back(judge(clip_case, clip, plan, method, static_cast<std::uint64_t>(seed)));
    }
  }
  return rows;
}

}  // namespace forge
