#include "collision_forge/attack/network/network_pattern_predictor.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "collision_forge/attack/network/network_ego_futures.h"
#include "collision_forge/attack/network/predicted_scene.h"

namespace forge {
namespace {

/// Returns the patterns' attackers, each once.
std::vector<const Track*> attackersOf(const std::vector<CollisionPattern>& patterns,
                                      const Snapshot& snapshot) {
  std::vector<const Track*> attackers;
  for (const CollisionPattern& pattern : patterns) {
    const bool known = std::any_of(attackers.begin(), attackers.end(), [&](const Track* track) {
      return track->id == pattern.attacker_id;
    });
    if (known) continue;
    for (const Track& agent : snapshot.agents) {
      if (agent.id == pattern.attacker_id) attackers.push_back(&agent);
    }
  }
  return attackers;
}

/// Returns the indices of the candidates, most probable attacker first.
std::vector<std::size_t> ranked(const std::vector<CandidatePrediction>& answers) {
  std::vector<std::size_t> order(answers.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return answers[a].score > answers[b].score;
  });
  return order;
}

/// Returns the pattern whose relative pose is nearest to `offset`.
std::vector<CollisionPattern>::iterator nearestTo(const Pose2& offset,
                                                  std::vector<CollisionPattern>& patterns,
                                                  const BoxSize& attacker) {
  const auto apart = [&](const CollisionPattern& pattern) {
    return cornerMiss(missBetween(offset, pattern.attacker_offset), attacker);
  };
  return std::min_element(patterns.begin(), patterns.end(),
                          [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
}

/// Returns the ego's pose at impact in its frame at t0.
Pose2 egoAtImpact(const PredictedScene& scene, const CollisionRequest& request,
                  const Future* recorded, double now, std::optional<CollisionType> known_type) {
  if (recorded) {
    const auto state = stateAt(recorded->ego, now + request.tta);
    if (state) return relativeTo(scene.ways().ego.state.pose, state->pose);
  }
  return medianPose(scene.egoAfter(request.tta, known_type));
}

}  // namespace

NetworkPatternPredictor::NetworkPatternPredictor(const AttackOptions& options,
                                                 PredictionModels models)
    : options_(options),
      models_(std::move(models)),
      kinematic_(options, std::make_shared<NetworkEgoFutures>(options.ego_futures, models_)) {}

PatternPrediction NetworkPatternPredictor::predict(const Snapshot& snapshot, const LaneIndex& lanes,
                                                   const CollisionRequest& request,
                                                   const Future* recorded) const {
  PatternPrediction prediction = kinematic_.predict(snapshot, lanes, request, recorded);
  if (!models_.network || !isPublished(request.type) || prediction.patterns.empty()) {
    return prediction;
  }
  const PredictedScene scene(*models_.network, snapshot, lanes, request.tta);
  const Pose2 ego = egoAtImpact(scene, request, recorded, snapshot.now, models_.known_type);
  const std::vector<const Track*> attackers = attackersOf(prediction.patterns, snapshot);
  const std::vector<CandidatePrediction> answers =
      scene.judge(attackers, ego, request.tta, request.type);
  std::vector<CollisionPattern> patterns;
  for (const std::size_t i : ranked(answers)) {
    std::vector<CollisionPattern> own;
    std::copy_if(prediction.patterns.begin(), prediction.patterns.end(), std::back_inserter(own),
                 [&](const auto& pattern) { return pattern.attacker_id == attackers[i]->id; });
    const auto nearest = nearestTo(answers[i].offset, own, attackers[i]->size);
    nearest->ego = boxAt(snapshot.ego, compose(scene.ways().ego.state.pose, ego));
    nearest->attacker_offset = answers[i].offset;
    nearest->tolerance = options_.prediction.network_pattern_tolerance;
    std::rotate(own.begin(), nearest, nearest + 1);
    patterns.insert(patterns.end(), own.begin(), own.end());
  }
  prediction.patterns = std::move(patterns);
  return prediction;
}

}  // namespace forge
