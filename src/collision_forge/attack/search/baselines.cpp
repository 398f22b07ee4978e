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

/// Returns where COLLIDE places an attacker of the type, in the ego box's frame.
Pose2 nominalOffset(CollisionType type, bool from_left, const NominalOptions& options) {
  const double side = from_left ? 1.0 : -1.0;
  const double turn = options.lane_change_heading;
  switch (type) {
    case CollisionType::kRearEnd:
      return {-options.end_distance, 0.0, 0.0};
    case CollisionType::kOppositeDirection:
      return {options.end_distance, 0.0, M_PI};
    case CollisionType::kLaneChange:
    case CollisionType::kSideswipeSameDirection:
      return {options.lane_change_ahead + std::sin(turn),
              side * (options.lane_change_side + std::cos(turn)), -side * turn};
    case CollisionType::kJunctionCrossing:
    case CollisionType::kLtap:
    case CollisionType::kAngleSameDirection:
    case CollisionType::kAngleOppositeDirection:
    case CollisionType::kAny:
      break;
  }
  return {0.0, side * options.side_distance, -side * M_PI_2};
}

/// Returns the ego's pose at the requested time.
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

/// Drives one quintic per axis to `pose`, arrives with the speed at t0, then goes straight on.
AttackerTrajectory drivenTo(const Pose2& pose, double tta, const Track& attacker,
                            const Motion& motion, double now, const SearchOptions& search) {
  Arrival arrival;
  arrival.time = tta;
  arrival.pose = pose;
  arrival.speed = motion.speed;
  arrival.start_acceleration = motion.acceleration;
  const int steps = static_cast<int>(std::lround((tta + search.tail) / search.step));
  AttackerTrajectory trajectory{attacker.id, attacker.agent_class, attacker.size, {}};
  driveQuintic({motion, now, search.step, steps + 1}, arrival, trajectory.points);
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
                  request.tta, attacker, motion, snapshot.now, options.search);
}

AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot, pattern.attacker_id);
  return drivenTo(compose(pattern.ego.center, pattern.attacker_offset), tta, attacker,
                  estimateMotion(attacker), snapshot.now, options.search);
}

Attack ConstantVelocityMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  return bestOfCandidates(moment, request, options_.prediction, [&](const std::string& attacker) {
    return drivenAttack(constantVelocityAttacker(attacker, moment.snapshot, request.tta, options_),
                        moment, request, options_);
  });
}

Attack NominalMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  return bestOfCandidates(moment, request, options_.prediction, [&](const std::string& attacker) {
    return drivenAttack(
        nominalAttacker(attacker, moment.snapshot, recordedOf(moment), request, options_), moment,
        request, options_);
  });
}

Attack PatternQuinticMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  const PatternPrediction prediction =
      predictor_->predict(moment.snapshot, *moment.lanes, request, recordedOf(moment));
  if (prediction.status.code != StatusCode::kOk) return rejection(prediction.status);
  const CollisionPattern& pattern = prediction.patterns.front();
  return drivenAttack(patternAttacker(pattern, moment.snapshot, request.tta, options_), moment,
                      request, options_, &pattern);
}

}  // namespace forge
