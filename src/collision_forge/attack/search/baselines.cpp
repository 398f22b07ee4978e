#include "collision_forge/attack/search/baselines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/driven_answer.h"
#include "collision_forge/attack/search/trajectory_family.h"

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
Pose2 egoAtImpact(const Snapshot& snapshot, const Future* recorded,
                  const CollisionRequest& request) {
  if (recorded) {
    const auto state = stateAt(recorded->ego, snapshot.now + request.tta);
    if (!state) throw std::invalid_argument("the ego's recording ends before the impact");
    return state->pose;
  }
  const Motion motion = estimateMotion(snapshot.ego);
  return compose(motion.pose, {motion.speed * request.tta, 0.0, 0.0});
}

const Future* recordedOf(const Moment& moment) {
  return moment.recorded ? &*moment.recorded : nullptr;
}

/// One quintic on each axis, then straight on.
AttackerTrajectory drivenTo(const Pose2& pose, const EndMotion& end, double tta,
                            const Track& attacker, const Motion& motion, double now,
                            const SearchOptions& search) {
  Arrival arrival;
  arrival.time = tta;
  arrival.pose = pose;
  arrival.speed = end.speed;
  arrival.start_acceleration = motion.acceleration;
  arrival.end_acceleration = end.acceleration;
  const int steps = static_cast<int>(std::lround((tta + search.tail) / search.step));
  AttackerTrajectory trajectory{attacker.id, attacker.agent_class, attacker.size, {}};
  QuinticFamily().drive({motion, now, search.step, steps + 1}, arrival, trajectory.points);
  return trajectory;
}

}  // namespace

AttackerTrajectory constantVelocityAttacker(const std::string& attacker_id,
                                            const Snapshot& snapshot, double tta,
                                            const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot, attacker_id);
  const Motion motion = estimateMotion(attacker);
  AttackerTrajectory trajectory{attacker.id, attacker.agent_class, attacker.size, {}};
  trajectory.points.push_back({snapshot.now, motion.pose, motion.speed, 0.0, 0.0});
  goStraightOn(trajectory, tta + options.search.tail, options.search.step);
  return trajectory;
}

AttackerTrajectory nominalAttacker(const std::string& attacker_id, const Snapshot& snapshot,
                                   const Future* recorded, const CollisionRequest& request,
                                   const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot, attacker_id);
  const Motion motion = estimateMotion(attacker);
  const Pose2 ego = egoAtImpact(snapshot, recorded, request);
  const bool from_left = relativeTo(ego, motion.pose).y > 0.0;
  return drivenTo(compose(ego, nominalOffset(request.type, from_left, options.nominal)),
                  {motion.speed, 0.0}, request.tta, attacker, motion, snapshot.now, options.search);
}

AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options,
                                   const std::optional<EndMotion>& end) {
  const Track& attacker = trackOf(snapshot, pattern.attacker_id);
  const Motion motion = estimateMotion(attacker);
  return drivenTo(compose(pattern.ego.center, pattern.attacker_offset),
                  end.value_or(EndMotion{motion.speed, 0.0}), tta, attacker, motion, snapshot.now,
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
  if (prediction.status.code != StatusCode::kOk) return declined(prediction.status);
  const CollisionPattern& pattern = prediction.patterns.front();
  return drivenAnswer(patternAttacker(pattern, moment.snapshot, request.tta, options_), moment,
                      request, options_, &pattern);
}

}  // namespace forge
