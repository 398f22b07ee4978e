#include "collision_forge/study/evaluation/published_search.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "collision_forge/attack/search/attack_search.h"
#include "collision_forge/attack/search/baselines.h"
#include "collision_forge/attack/search/pattern_predictor.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/published.h"

namespace forge {
namespace {

constexpr double kNone = 1e6;     // an unreachable limit
constexpr double kSimilar = 0.3;  // score of a similar heading, in addition to 1 for the hit

/// Returns the clip with all agents but the attacker moving as in `future` after t0; agents without
/// a state at the time of a frame are missing in it.
CollideClip withFuture(CollideClip clip, const Future& future, const Track& ego) {
  const std::string ego_id = clip.ego().id;
  for (CollideTrack& track : clip.tracks) {
    if (track.id == clip.attacker_id) continue;
    const Track* known = findTrack(future.agents, track.id);
    for (std::size_t frame = kCollideNowFrame + 1; frame < track.frames.size(); ++frame) {
      const double time = clip.times[frame];
      std::optional<AgentState> state;
      if (track.id == ego_id) {
        state = stateAt(ego, time);
      } else if (known) {
        state = stateAt(*known, time);
      }
      track.frames[frame].reset();
      if (state) track.frames[frame] = CollideState{state->pose, state->velocity.norm()};
    }
  }
  return clip;
}

/// Returns one clip per predicted future of the ego, at most about `count`, equally likely.
std::vector<CollideClip> likelyClips(CollideClip clip, const Future& future, double angle,
                                     int count) {
  clip.angle = angle;
  std::vector<CollideClip> clips;
  const std::size_t samples = future.ego_samples.size();
  const std::size_t stride = std::max<std::size_t>(1, samples / static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < samples; i += stride) {
    clips.push_back(withFuture(clip, future, future.ego_samples[i]));
  }
  if (clips.empty()) clips.push_back(withFuture(clip, future, future.ego));
  return clips;
}

double score(const std::vector<CollideClip>& clips, const AttackerTrajectory& trajectory,
             const PublishedOptions& options) {
  double sum = 0.0;
  for (const CollideClip& clip : clips) {
    const PublishedOutcome outcome = publishedOutcome(clip, framesOf(clip, trajectory), options);
    if (outcome.isHit()) sum += 1.0;
    if (outcome.similar) sum += kSimilar;
  }
  return sum;
}

}  // namespace

AttackOptions withPublishedObjective(AttackOptions options, const EvaluationOptions& evaluation) {
  const PublishedSearchOptions& wanted = evaluation.published_search;
  options.verification.limits = {kNone, kNone, kNone, kNone, kNone, 0.0, kNone, kNone};
  options.verification.limits.max_speed = wanted.max_speed;
  SearchOptions& search = options.search;
  search.overlap_margin = wanted.overlap_margin;
  search.max_lead = wanted.max_lead;
  search.bicycle_targets = search.bicycle_rounds = 0;
  search.steering_rounds = 0;
  search.kept = wanted.kept;
  search.off_road_weight = 0.0;
  search.good_off_road = 1.0;
  search.steering_weight = 0.0;
  search.good_steering = kNone;
  search.good_share = 1.0;
  return options;
}

CrashDefinition withPublishedObjective(CrashDefinition crash, const NominalOptions& nominal,
                                       const PublishedSearchOptions& options) {
  crash = rulesOfClips(std::move(crash));
  for (auto& [type, definition] : crash.types) {
    if (type == CollisionType::kLaneChange) {
      definition.nominal_heading = nominal.lane_change_heading;
    }
    definition.min_heading = std::max(0.0, definition.nominal_heading - options.heading_tolerance);
    definition.max_heading = std::min(M_PI, definition.nominal_heading + options.heading_tolerance);
  }
  return crash;
}

AttackerTrajectory publishedSearchAttacker(const CollideClip& clip, const Snapshot& snapshot,
                                           const Future* recorded, const CollisionRequest& request,
                                           const LaneIndex& lanes,
                                           std::shared_ptr<const EgoFutureSampler> ego_futures,
                                           const AttackOptions& options,
                                           const EvaluationOptions& evaluation) {
  const AttackOptions objective = withPublishedObjective(options, evaluation);
  CollisionRequest any_time = request;
  any_time.crash =
      withPublishedObjective(request.crash, options.nominal, evaluation.published_search);
  const KinematicPatternPredictor predictor(objective, std::move(ego_futures));
  const PatternPrediction prediction = predictor.predict(snapshot, lanes, any_time, recorded);
  const Future& future = prediction.future;
  std::vector<const Track*> egos;
  for (const Track& sample : future.ego_samples) egos.push_back(&sample);
  if (egos.empty()) egos.push_back(&future.ego);

  const std::vector<CollideClip> clips = likelyClips(clip, future, any_time.bands().nominal_heading,
                                                     evaluation.published_search.futures);
  // A band about half the latest contact time covers all times from t0 on.
  any_time.tta = 0.5 * (request.tta + evaluation.published_search.latest);
  any_time.crash.time_tolerance = any_time.tta;
  AttackerTrajectory best = nominalAttacker(clip.attacker_id, snapshot, recorded, request, options);
  double best_score = score(clips, best, evaluation.published);
  for (const FoundAttack& attack :
       searchAttacks({snapshot, future, egos, prediction.patterns, any_time, lanes}, objective)) {
    AttackerTrajectory candidate = best;
    candidate.points = attack.points;
    const double candidate_score = score(clips, candidate, evaluation.published);
    if (candidate_score <= best_score) continue;
    best_score = candidate_score;
    best = std::move(candidate);
  }
  return best;
}

}  // namespace forge
