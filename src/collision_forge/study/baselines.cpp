#include "collision_forge/study/baselines.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/attack/trajectory_family.h"
#include "collision_forge/forecast/motion_estimate.h"

namespace forge {
namespace {

const CollideState& attackerAt(const CollideClip& clip, std::size_t frame) {
  return *clip.attacker().frames[frame];
}

/// Degree five in time on both axes through six frames in a row.
class FrameQuintic {
 public:
  static constexpr int kFrames = 6;

  FrameQuintic(const CollideClip& clip, std::size_t first)
      : start_(clip.times[first]), scale_(clip.times[first + kFrames - 1] - start_) {
    Eigen::Matrix<double, kFrames, kFrames> powers;
    Eigen::Matrix<double, kFrames, 2> positions;
    origin_ = attackerAt(clip, first).pose.position();
    for (int row = 0; row < kFrames; ++row) {
      const std::size_t frame = first + static_cast<std::size_t>(row);
      const double t = (clip.times[frame] - start_) / scale_;
      for (int power = 0; power < kFrames; ++power) powers(row, power) = std::pow(t, power);
      positions.row(row) = (attackerAt(clip, frame).pose.position() - origin_).transpose();
    }
    coefficients_ = powers.partialPivLu().solve(positions);
  }

  /// The motion at `time`, seen along `yaw`.
  TrajectoryPoint at(double time, double yaw) const {
    const double t = (time - start_) / scale_;
    Vector2 position = Vector2::Zero();
    Vector2 velocity = Vector2::Zero();
    Vector2 acceleration = Vector2::Zero();
    for (int power = kFrames - 1; power >= 0; --power) {  // Horner's scheme, with derivatives
      acceleration = acceleration * t + 2.0 * velocity;
      velocity = velocity * t + position;
      position = position * t + coefficients_.row(power).transpose();
    }
    position += origin_;
    velocity /= scale_;
    acceleration /= scale_ * scale_;
    const Vector2 heading(std::cos(yaw), std::sin(yaw));
    TrajectoryPoint point{time,
                          {position.x(), position.y(), yaw},
                          velocity.dot(heading),
                          acceleration.dot(heading),
                          0.0};
    const double speed = velocity.norm();
    constexpr double kStandstill = 0.1;  // m/s; below it the curvature is not defined well
    if (speed > kStandstill) {
      point.curvature = (velocity.x() * acceleration.y() - velocity.y() * acceleration.x()) /
                        (speed * speed * speed);
    }
    return point;
  }

 private:
  double start_;
  double scale_;  // s; times are divided by it, which keeps the powers small
  Vector2 origin_;
  Eigen::Matrix<double, kFrames, 2> coefficients_;
};

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

/// Instants from now to the last frame, about `step` apart, both ends included.
std::vector<double> instants(const CollideClip& clip, double step) {
  const int steps = std::max(1, static_cast<int>(std::lround(clip.tta() / step)));
  std::vector<double> times;
  for (int i = 0; i < steps; ++i) times.push_back(clip.now() + clip.tta() * i / steps);
  times.push_back(clip.times.back());
  return times;
}

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
Pose2 egoAtImpact(const Snapshot& snapshot, const Future& recorded, const CollisionRequest& request,
                  const AttackOptions& options) {
  const auto state = stateAt(recorded.ego, snapshot.now + request.tta);
  if (request.mode == Mode::kReplay) {
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

/// Linear between the points, and the last one after them.
Pose2 poseAt(const AttackerTrajectory& trajectory, double time) {
  const auto& points = trajectory.points;
  const auto after = std::lower_bound(
      points.begin(), points.end(), time,
      [](const TrajectoryPoint& point, double value) { return point.time < value; });
  if (after == points.begin()) return points.front().pose;
  if (after == points.end()) return points.back().pose;
  const TrajectoryPoint& before = *std::prev(after);
  return interpolate(before.pose, after->pose, (time - before.time) / (after->time - before.time));
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

}  // namespace

CollisionRequest requestOf(const CollideClip& clip, Mode mode, double min_tta) {
  CollisionRequest request;
  request.type = clip.type;
  request.tta = std::max(clip.tta(), min_tta);
  request.attacker = clip.attacker_id;
  request.mode = mode;
  return request;
}

AttackerTrajectory recordedAttacker(const CollideClip& clip, const BoxSize& box,
                                    const SearchOptions& search) {
  AttackerTrajectory trajectory{clip.attacker_id, AgentClass::kCar, box, {}};
  std::size_t frame = kCollideNowFrame;  // the one at or before each instant
  const std::size_t last_interval = clip.times.size() - 2;
  const std::size_t last_first = clip.times.size() - FrameQuintic::kFrames;
  for (const double time : instants(clip, search.step)) {
    while (frame < last_interval && clip.times[frame + 1] <= time) ++frame;
    const double ratio = (time - clip.times[frame]) / (clip.times[frame + 1] - clip.times[frame]);
    const double yaw =
        interpolate(attackerAt(clip, frame).pose, attackerAt(clip, frame + 1).pose, ratio).yaw;
    const FrameQuintic quintic(clip, std::min(frame - 2, last_first));
    trajectory.points.push_back(quintic.at(time, yaw));
  }
  goStraightOn(trajectory, search.tail, search.step);
  return trajectory;
}

AttackerTrajectory constantVelocityAttacker(const CollideClip& clip, const BoxSize& box,
                                            const SearchOptions& search) {
  const CollideState& now = attackerAt(clip, kCollideNowFrame);
  AttackerTrajectory trajectory{clip.attacker_id, AgentClass::kCar, box, {}};
  trajectory.points.push_back({clip.now(), now.pose, now.speed, 0.0, 0.0});
  goStraightOn(trajectory, clip.tta() + search.tail, search.step);
  return trajectory;
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
                                   const Future& recorded, const CollisionRequest& request,
                                   const NominalOptions& nominal, const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot.agents, attacker_id);
  const Motion motion = estimateMotion(attacker, options.prediction.motion_frames);
  const Pose2 ego = egoAtImpact(snapshot, recorded, request, options);
  const bool from_left = relativeTo(ego, motion.pose).y > 0.0;
  return drivenTo(compose(ego, nominalOffset(request.type, from_left, nominal)), request.tta,
                  attacker, motion, snapshot.now, options.search);
}

AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options) {
  const Track& attacker = trackOf(snapshot.agents, pattern.attacker_id);
  return drivenTo(compose(pattern.ego.center, pattern.attacker_offset), tta, attacker,
                  estimateMotion(attacker, options.prediction.motion_frames), snapshot.now,
                  options.search);
}

std::vector<Pose2> framesOf(const CollideClip& clip, const AttackerTrajectory& trajectory) {
  std::vector<Pose2> frames = recordedFrames(clip);
  for (std::size_t frame = kCollideNowFrame + 1; frame < frames.size(); ++frame) {
    frames[frame] = poseAt(trajectory, clip.times[frame]);
  }
  return frames;
}

std::vector<Pose2> recordedFrames(const CollideClip& clip) {
  std::vector<Pose2> frames;
  for (const auto& state : clip.attacker().frames) frames.push_back(state->pose);
  return frames;
}

}  // namespace forge
