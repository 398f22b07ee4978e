#include "collision_forge/attack/search/pattern_predictor.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kRearEndClosingSpeed =
    4.0;  // m/s, nominal, of a rear-end attacker above the ego's speed
constexpr double kMinImpactSpeed = 3.0;  // m/s, nominal, of every other attacker at least
constexpr double kStraight = 1e-3;       // sine of a heading rounded from 0 or pi

struct RankedPattern {
  CollisionPattern pattern;
  double cost = 0.0;
};

/// Returns the difference between the mean speed needed to reach the impact and the mean of start
/// and impact speed.
double speedMismatch(const CollisionPattern& pattern, const Motion& motion, double tta) {
  const Pose2 impact = compose(pattern.ego.center, pattern.attacker_offset);
  const double distance = (impact.position() - motion.pose.position()).norm();
  return std::abs(distance / tta - 0.5 * (motion.speed + pattern.attacker_speed));
}

/// Returns true if the agent's approach fits the type.
bool approachFitsType(const Track& agent, const Snapshot& snapshot,
                      const CollisionRequest& request) {
  if (request.crash.rules == TypeRules::kAngle) return true;
  if (isOnFoot(agent.agent_class)) return true;  // turns on the spot
  const double approach =
      angleBetween(snapshot.ego.states.back().pose.yaw, agent.states.back().pose.yaw);
  return approachFits(approach, request.bands());
}

/// Places the agent at the ego's pose at impact, with this heading, pushed in from `side`.
RankedPattern placedPattern(const Track& agent, Side side, double heading, const AgentState& ego,
                            const Snapshot& snapshot, const CollisionRequest& request,
                            const PredictionOptions& prediction) {
  const Motion motion = estimateMotion(agent);
  CollisionPattern pattern;
  pattern.type = request.type;
  pattern.attacker_id = agent.id;
  pattern.time = snapshot.now + request.tta;
  pattern.ego = boxAt(snapshot.ego, ego.pose);
  pattern.attacker_offset = attackerOffset(snapshot.ego.size, agent.size, side, heading, 0.0, 0.0);
  pattern.attacker_speed = request.type == CollisionType::kRearEnd
                               ? ego.velocity.norm() + kRearEndClosingSpeed
                               : std::max(motion.speed, kMinImpactSpeed);
  pattern.tolerance = prediction.pattern_tolerance;
  return {pattern, speedMismatch(pattern, motion, request.tta)};
}

/// Returns the type's nominal heading at a placement, with both signs if either is allowed.
std::vector<double> headingsAt(const Placement& placement, double nominal) {
  if (placement.sign != 0.0) return {wrapAngle(placement.sign * nominal)};
  if (std::abs(std::sin(nominal)) < kStraight) return {wrapAngle(nominal)};
  return {nominal, -nominal};
}

/// Returns the track whose position at `time` is nearest to the mean position.
const Track& mostCentral(const std::vector<Track>& tracks, double time) {
  const auto placeOf = [time](const Track& track) {
    return stateAt(track, time).value_or(track.states.back()).pose.position();
  };
  Vector2 mean = Vector2::Zero();
  for (const Track& track : tracks) mean += placeOf(track) / static_cast<double>(tracks.size());
  return *std::min_element(tracks.begin(), tracks.end(), [&](const Track& a, const Track& b) {
    return (placeOf(a) - mean).squaredNorm() < (placeOf(b) - mean).squaredNorm();
  });
}

}  // namespace

Future predictWithEgoSamples(const Snapshot& snapshot, const LaneIndex& lanes,
                             const EgoFutureSampler& ego_futures, double horizon,
                             double central_time, int samples, std::uint64_t seed) {
  Future future = predictFuture(snapshot, lanes, horizon);
  future.ego_samples = ego_futures.sample(snapshot, lanes, horizon, samples, seed);
  if (!future.ego_samples.empty()) {
    future.ego = mostCentral(future.ego_samples, snapshot.now + central_time);
  }
  return future;
}

KinematicPatternPredictor::KinematicPatternPredictor(
    const AttackOptions& options, std::shared_ptr<const EgoFutureSampler> ego_futures)
    : options_(options.prediction),
      believability_(options.verification.believability),
      ego_futures_(std::move(ego_futures)) {}

PatternPrediction KinematicPatternPredictor::predict(const Snapshot& snapshot,
                                                     const LaneIndex& lanes,
                                                     const CollisionRequest& request,
                                                     const Future* recorded) const {
  PatternPrediction prediction;
  prediction.future =
      recorded ? *recorded
               : predictWithEgoSamples(snapshot, lanes, *ego_futures_, request.tta + options_.tail,
                                       request.tta, options_.ego_samples, request.seed);
  const auto ego = stateAt(prediction.future.ego, snapshot.now + request.tta);
  if (!ego) {
    prediction.status = {StatusCode::kBeyondRecording,
                         "the ego's recording ends before the contact, tta = " +
                             numberText(request.tta) + " s after t0"};
    return prediction;
  }
  CollisionRequest on_road = request;
  if (asksForPedestrian(request, snapshot)) on_road.attacker_class = AgentClass::kPedestrian;
  if (request.crash.believable &&
      !roadAllows(prediction.future, snapshot.now, on_road, lanes, believability_)) {
    prediction.status = {StatusCode::kRoadDoesNotAllow, roadRefusal(request)};
    return prediction;
  }
  const double nominal = request.bands().nominal_heading;
  std::vector<RankedPattern> ranked;
  for (const Track& agent : snapshot.agents) {
    if (request.attacker && agent.id != *request.attacker) continue;
    if (request.attacker_class && agent.agent_class != *request.attacker_class) continue;
    // A requested attacker was checked before and may be anywhere.
    if (!request.attacker && !isCandidate(agent, snapshot, options_, request.attacker_class))
      continue;
    if (request.departure_time && !stands(agent)) continue;
    if (!approachFitsType(agent, snapshot, request)) continue;
    for (const Placement& placement :
         placementsOf(request.type, lanes.map().driving_side, request.turning)) {
      for (const double heading : headingsAt(placement, nominal)) {
        ranked.push_back(
            placedPattern(agent, placement.side, heading, *ego, snapshot, request, options_));
      }
    }
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.cost < b.cost; });
  for (RankedPattern& entry : ranked) prediction.patterns.push_back(std::move(entry.pattern));
  if (prediction.patterns.empty()) {
    prediction.status = {
        StatusCode::kNoCandidate,
        "no vehicle within candidate_radius = " + numberText(options_.candidate_radius) +
            " m, observed at t0 and in the frame before, " +
            (request.departure_time ? "stands at t0 as departure_time requires and " : "") +
            "approaches from the direction of type = " + toString(request.type)};
  }
  return prediction;
}

}  // namespace forge
