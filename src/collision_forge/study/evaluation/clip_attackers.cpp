#include "collision_forge/study/evaluation/clip_attackers.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/attack/search/driven_answer.h"

namespace forge {
namespace {

const CollideState& attackerAt(const CollideClip& clip, std::size_t frame) {
  return *clip.attacker().frames[frame];
}

/// Polynomial of degree five in time for x and y through six consecutive frames.
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

  /// Returns the motion at `time` (s), with speed and acceleration projected on the heading `yaw`.
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
  double scale_;  // s; divides the times for numerical stability
  Vector2 origin_;
  Eigen::Matrix<double, kFrames, 2> coefficients_;
};

/// Returns the times (s) from t0 to the last frame, both included, about `step` s apart.
std::vector<double> instants(const CollideClip& clip, double step) {
  const int steps = std::max(1, static_cast<int>(std::lround(clip.tta() / step)));
  std::vector<double> times;
  for (int i = 0; i < steps; ++i) times.push_back(clip.now() + clip.tta() * i / steps);
  times.push_back(clip.times.back());
  return times;
}

}  // namespace

CollisionRequest requestOf(const CollideClip& clip, Mode mode, double min_tta,
                           CrashDefinition crash) {
  CollisionRequest request;
  request.type = clip.type;
  request.tta = std::max(clip.tta(), min_tta);
  request.attacker = clip.attacker_id;
  request.mode = mode;
  request.crash = std::move(crash);
  return request;
}

AttackerTrajectory recordedAttacker(const CollideClip& clip, const BoxSize& box,
                                    const SearchOptions& search) {
  AttackerTrajectory trajectory{clip.attacker_id, AgentClass::kCar, box, {}};
  std::size_t frame = kCollideNowFrame;  // last frame at or before the instant
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
