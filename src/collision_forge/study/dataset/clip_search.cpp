#include "collision_forge/study/dataset/clip_search.h"

#include <algorithm>
#include <memory>
#include <set>

#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/attack/search/search_method.h"
#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/io/collide/collide_export.h"
#include "collision_forge/study/dataset/seeds.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"

namespace forge {
namespace {

constexpr int kHistoryFrames = kCollideNowFrame + 1;

/// Predicts patterns only for vehicles that were recorded in every frame of the history.
class ContinuousPatterns : public PatternPredictor {
 public:
  explicit ContinuousPatterns(const AttackOptions& options) : patterns_(options, nullptr) {}

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request,
                            const Future* recorded) const override {
    PatternPrediction prediction = patterns_.predict(snapshot, lanes, request, recorded);
    if (prediction.status.code != StatusCode::kOk) return prediction;
    auto& patterns = prediction.patterns;
    patterns.erase(std::remove_if(patterns.begin(), patterns.end(),
                                  [&](const CollisionPattern& pattern) {
                                    return !isContinuous(pattern.attacker_id, snapshot);
                                  }),
                   patterns.end());
    if (patterns.empty()) {
      prediction.status = {StatusCode::kNoCandidate, "no candidate vehicle was recorded in all " +
                                                         std::to_string(kHistoryFrames) +
                                                         " frames up to t0"};
    }
    return prediction;
  }

 private:
  static bool isContinuous(const std::string& id, const Snapshot& snapshot) {
    const Track* agent = findTrack(snapshot.agents, id);
    return agent && agent->states.size() == static_cast<std::size_t>(kHistoryFrames);
  }

  KinematicPatternPredictor patterns_;  // in replay mode, which needs no sampled futures
};

/// Returns the conditions of a clip: the full definition of the type, the data set's time
/// tolerance, and the band of headings narrowed about the drawn heading.
CrashDefinition clipCrash(CrashDefinition crash, const CollisionRequest& request,
                          const DatasetOptions& options) {
  crash.rules = TypeRules::kFull;
  crash.time_tolerance = options.time_tolerance;
  TypeDefinition& definition = crash.types.at(request.type);
  definition = narrowedAbout(definition, drawnHeading(request, definition), options.heading_spread);
  return crash;
}

/// Returns the measures of a protocol that the clip does not meet, as a message, or "". Ignores the
/// motion limits, which cannot be derived from 2 Hz frames, and the similarity, because headings
/// held between frames distort it in turns.
std::string unmetMeasures(const CollideClip& clip, const IndexedScene& indexed,
                          const StudyOptions& study, Protocol protocol) {
  static const std::set<std::string> left_out = {"angle_bands", "full_definitions", "limits_kept",
                                                 "similar"};
  EvaluationPlan plan;
  plan.protocol = protocol;
  plan.mode = Mode::kReplay;
  const std::vector<ResultRow> rows =
      evaluateClip(clip, indexed.lanes, {builtInMethods(), {}, study}, plan);
  const ResultRow& row = rows.front();
  const std::vector<Measure>& measures = measuresOf(protocol);
  std::string missed;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (!row.meets[i] && left_out.count(measures[i].name) == 0) missed += " " + measures[i].name;
  }
  if (missed.empty()) return {};
  return std::string("the clip does not meet these measures of the ") + toString(protocol) +
         " protocol:" + missed;
}

/// Returns the reason why an attack cannot become a clip, or "".
std::string rejectionReason(const Scenario& scenario, const IndexedScene& indexed,
                            const Moment& moment, const StudyOptions& study,
                            const DatasetOptions& options) {
  CollisionRequest request = scenario.asked.request;
  request.crash = study.crash;
  request.crash.time_tolerance = options.time_tolerance;
  const StrictOutcome outcome = strictOutcome(
      scenario.answer.trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes},
      study.attack.verification);
  if (!outcome.meetsFullDefinitions()) {
    return "against the recording, the attack does not meet the full definition of the type";
  }
  if (outcome.report.off_road_share > options.max_off_road_share) {
    return formatted("leaves the road: off_road_share = %.3f is above %.3f",
                     outcome.report.off_road_share, options.max_off_road_share);
  }
  const auto clip = toCollideClip(scenario, indexed.scene, 0);
  if (const auto* obstacle = std::get_if<ClipObstacle>(&clip)) {
    return std::string("cannot be written in COLLIDE's layout: ") + toString(*obstacle);
  }
  for (const Protocol protocol : {Protocol::kStrict, Protocol::kPublished}) {
    const std::string missed = unmetMeasures(std::get<CollideClip>(clip), indexed, study, protocol);
    if (!missed.empty()) return missed;
  }
  return {};
}

}  // namespace

TypeDefinition narrowedAbout(const TypeDefinition& definition, double heading, double spread) {
  TypeDefinition narrowed = definition;
  const double half = std::min(spread, 0.5 * (definition.max_heading - definition.min_heading));
  const double middle =
      std::clamp(heading, definition.min_heading + half, definition.max_heading - half);
  narrowed.min_heading = middle - half;
  narrowed.max_heading = middle + half;
  narrowed.nominal_heading = heading;
  return narrowed;
}

double drawnHeading(const CollisionRequest& request, const TypeDefinition& definition) {
  const double share = shareOf(seedOf("heading", request.seed));
  return definition.min_heading + share * (definition.max_heading - definition.min_heading);
}

Realization findClip(const SceneRequest& asked, const IndexedScene& indexed,
                     const StudyOptions& study, const DatasetOptions& options) {
  Scenario scenario{asked, egoVehicleOf(indexed.scene, study.ego_vehicle.center_offset), {}};
  const auto found = momentAt(indexed, asked.now, kHistoryFrames);
  if (const Status* status = std::get_if<Status>(&found)) {
    scenario.answer.status = *status;
    return scenario.answer;
  }
  const Moment& moment = std::get<Moment>(found);
  CollisionRequest request = asked.request;
  request.crash = clipCrash(study.crash, request, options);
  request.choice = options.choice;
  const PredictionOptions& prediction = study.attack.prediction;
  const SearchMethod method(study.attack, std::make_shared<ContinuousPatterns>(study.attack));
  scenario.answer = generateCollision(method, moment, request, prediction);
  if (scenario.answer.status.code != StatusCode::kOk) return scenario.answer;
  const std::string problem = rejectionReason(scenario, indexed, moment, study, options);
  if (problem.empty()) return scenario.answer;
  return declined({StatusCode::kNoAttackWithinLimits, problem});
}

}  // namespace forge
