#include "collision_forge/attack/baselines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/request_check.h"
#include "collision_forge/attack/trajectory_family.h"
#include "collision_forge/forecast/kinematic_prediction.h"
#include "collision_forge/forecast/motion_estimate.h"

namespace forge {
namespace {

/// Where the set puts an attacker of the type, in the frame of the ego's box.
Pose2 nominalOffset(CollisionType type, bool from_left, const NominalOptions& options) {
  const double side = from_left ? 1.0 : -1.0;
  const double turn = options.lane_change_heading;
  switch (type) {
    case CollisionType::kRearEnd:
      return {-options.end_distance, 0.0, 0.0};
    case CollisionType::kOppositeDirection:
      return {options.end_distance, 0.0, M_PI};
    case CollisionType::kLaneChange:
      return {options.lane_change_ahead + std::sin(turn),
              side * (options.lane_change_side + std::cos(turn)), -side * turn};
    case CollisionType::kJunctionCrossing:
    case CollisionType::kLtap:
      break;
  }
  return {0.0, side * options.side_distance, -side * M_PI_2};
}

/// The ego's pose at the time asked for.
Pose2 egoAtImpact(const Snapshot& snapshot, const Future* recorded, const CollisionRequest& request,
                  const AttackOptions& options) {
  if (recorded) {
    const auto state = stateAt(recorded->ego, snapshot.now + request.tta);
    if (!state) throw std::invalid_argument("the ego's recording ends before the impact");
    return state->pose;
  }
  const Motion motion = estimateMotion(snapshot.ego, options.prediction.motion_frames);
  return compose(motion.pose, {motion.speed * request.tta, 0.0, 0.0});
}

const Track& trackOf(const std::vector<Track>& tracks, const std::string& id) {
  const auto found = std::find_if(tracks.begin(), tracks.end(),
                                  [&](const Track& track) { return track.id == id; });
  if (found == tracks.end()) throw std::invalid_argument("no track \"" + id + "\" in the snapshot");
  return *found;
}

/// One quintic on each axis, with the speed of now at its end, then straight on.
AttackerTrajectory drivenTo(const Pose2& pose, double tta, const Track& attacker,
                            const Motion& motion, double now, const SearchOptions& search) {
  Arrival arrival;
  arrival.time = tta;
  arrival.pose = pose;
  arrival.speed = motion.speed;
  arrival.start_acceleration = motion.acceleration;
  const int steps = static_cast<int>(std::lround((tta + search.tail) / search.step));
  AttackerTrajectory trajectory{attacker.id, attacker.agent_class, attacker.size, {}};
  QuinticFamily().drive({motion, now, search.step, steps + 1}, arrival, trajectory.points);
  return trajectory;
}

/// The answer that drives this; what a verification against the expected future says is in it, by
/// the strict limits. Whoever aims at no pattern aims at the contact that comes of it.
Realization drivenAnswer(AttackerTrajectory trajectory, const Moment& moment,
                         CollisionRequest request, const AttackOptions& options,
                         const CollisionPattern* aim = nullptr) {
  request.crash.limits = LimitSet::kStrict;
  const PredictionOptions& prediction = options.prediction;
  const Future future = moment.recorded ? *moment.recorded
                                        : predictFuture(moment.snapshot, *moment.lanes,
                                                        request.tta + prediction.tail, prediction);
  Realization answer;
  answer.report =
      verify(trajectory, {moment.snapshot, future, request, *moment.lanes}, options.verification);
  const CollisionReport& report = answer.report;
  const Pose2 met = relativeTo(report.ego_at_contact, report.attacker_at_contact);
  answer.aim = aim ? *aim
                   : CollisionPattern{request.type,
                                      trajectory.attacker_id,
                                      report.contact_time,
                                      {report.ego_at_contact, moment.snapshot.ego.size},
                                      met,
                                      trajectory.points.back().speed};
  answer.miss = missBetween(answer.aim.attacker_offset, met);
  answer.trajectory = std::move(trajectory);
  return answer;
}

const Future* recordedOf(const Moment& moment) {
  return moment.recorded ? &*moment.recorded : nullptr;
}

Realization refusal(const Status& status) {
  Realization refused;
  refused.status = status;
  return refused;
}

/// The attacker asked for, else the first candidate with the best answer: verified, else touching.
template <typename Answer>
Realization bestOfCandidates(const Moment& moment, const CollisionRequest& request,
                             const PredictionOptions& options, Answer answer_of) {
  if (request.attacker) return answer_of(*request.attacker);
  std::optional<Realization> best;
  const auto rank = [](const Realization& answer) {
    return answer.report.verified() ? 2 : answer.report.contact ? 1 : 0;
  };
  for (const Track& agent : moment.snapshot.agents) {
    if (!isCandidate(agent, moment.snapshot, options)) continue;
    if (request.attacker_class && agent.agent_class != *request.attacker_class) continue;
    Realization answer = answer_of(agent.id);
    if (!best || rank(answer) > rank(*best)) best = std::move(answer);
  }
  if (best) return std::move(*best);
  return refusal({StatusCode::kNoCandidate,
                  "no vehicle within candidate_radius, seen now and in the frame before"});
}

}  // namespace

/// Straight on from the last point for as long as `duration`.
void goStraightOn(AttackerTrajectory& trajectory, double duration, double step) {
  const TrajectoryPoint last = trajectory.points.back();
  const int steps = static_cast<int>(std::lround(duration / step));
  for (int i = 1; i <= steps; ++i) {
    const double elapsed = i * step;
    trajectory.points.push_back({last.time + elapsed,
                                 compose(last.pose, {last.speed * elapsed, 0.0, 0.0}), last.speed,
                                 0.0, 0.0});
  }
}

AttackerTrajectory constantVelocityAttacker(const std::string& attacker_id,
                                            const Snapshot& snapshot, double tta,
                                            const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot.agents, attacker_id);
  const Motion motion = estimateMotion(attacker, options.prediction.motion_frames);
  AttackerTrajectory trajectory{attacker.id, attacker.agent_class, attacker.size, {}};
  trajectory.points.push_back({snapshot.now, motion.pose, motion.speed, 0.0, 0.0});
  goStraightOn(trajectory, tta + options.search.tail, options.search.step);
  return trajectory;
}

AttackerTrajectory nominalAttacker(const std::string& attacker_id, const Snapshot& snapshot,
                                   const Future* recorded, const CollisionRequest& request,
                                   const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot.agents, attacker_id);
  const Motion motion = estimateMotion(attacker, options.prediction.motion_frames);
  const Pose2 ego = egoAtImpact(snapshot, recorded, request, options);
  const bool from_left = relativeTo(ego, motion.pose).y > 0.0;
  return drivenTo(compose(ego, nominalOffset(request.type, from_left, options.nominal)),
                  request.tta, attacker, motion, snapshot.now, options.search);
}

AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot.agents, pattern.attacker_id);
  return drivenTo(compose(pattern.ego.center, pattern.attacker_offset), tta, attacker,
                  estimateMotion(attacker, options.prediction.motion_frames), snapshot.now,
                  options.search);
}

Realization ConstantVelocityMethod::answer(const Moment& moment,
                                           const CollisionRequest& request) const {
  return bestOfCandidates(moment, request, options_.prediction, [&](const std::string& attacker) {
    return drivenAnswer(constantVelocityAttacker(attacker, moment.snapshot, request.tta, options_),
                        moment, request, options_);
  });
}

Realization NominalMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  return bestOfCandidates(moment, request, options_.prediction, [&](const std::string& attacker) {
    return drivenAnswer(
        nominalAttacker(attacker, moment.snapshot, recordedOf(moment), request, options_), moment,
        request, options_);
  });
}

Realization PatternQuinticMethod::answer(const Moment& moment,
                                         const CollisionRequest& request) const {
  const PatternPrediction prediction =
      predictor_->predict(moment.snapshot, *moment.lanes, request, recordedOf(moment));
  if (prediction.status.code != StatusCode::kOk) return refusal(prediction.status);
  const CollisionPattern& pattern = prediction.patterns.front();
  return drivenAnswer(patternAttacker(pattern, moment.snapshot, request.tta, options_), moment,
                      request, options_, &pattern);
}

}  // namespace forge
