#include "collision_forge/study/generators/generator_method.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/driven_answer.h"

namespace forge {
namespace {

/// A predicted frame of the attacker.
struct Knot {
  double time = 0.0;
  Pose2 pose;
  Vector2 velocity{0.0, 0.0};
};

/// Sets the velocities of the frames: the estimated one at t0, central differences afterwards.
void findVelocities(std::vector<Knot>& knots, const Motion& now) {
  knots.front().velocity = now.speed * now.pose.heading();
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Knot& before = knots[i - 1];
    const Knot& after = knots[std::min(i + 1, knots.size() - 1)];
    knots[i].velocity =
        (after.pose.position() - before.pose.position()) / (after.time - before.time);
  }
}

/// Interpolates between two frames: cubic Hermite positions, linear headings.
TrajectoryPoint between(const Knot& from, const Knot& to, double time) {
  const double span = to.time - from.time;
  const double t = (time - from.time) / span;
  const Vector2 way = to.pose.position() - from.pose.position();
  const Vector2 first = span * from.velocity;
  const Vector2 bend = 3.0 * way - 2.0 * first - span * to.velocity;
  const Vector2 twist = first + span * to.velocity - 2.0 * way;
  const Vector2 place = from.pose.position() + t * (first + t * (bend + t * twist));
  const Vector2 velocity = (first + t * (2.0 * bend + t * 3.0 * twist)) / span;
  const Vector2 acceleration = (2.0 * bend + t * 6.0 * twist) / (span * span);
  const double yaw = interpolate(from.pose, to.pose, t).yaw;
  const Pose2 pose{place.x(), place.y(), yaw};
  const double speed = velocity.dot(pose.heading());
  const double yaw_rate = angleBetween(from.pose.yaw, to.pose.yaw) / span;
  constexpr double kStandstill = 0.1;  // m/s; below it the curvature is ill-defined
  return {time, pose, speed, acceleration.dot(pose.heading()),
          std::abs(speed) > kStandstill ? yaw_rate / speed : 0.0};
}

std::vector<TrajectoryPoint> smoothThrough(const std::vector<Knot>& knots, double step) {
  std::vector<TrajectoryPoint> points;
  const double span = knots.back().time - knots.front().time;
  const int steps = std::max(1, static_cast<int>(std::lround(span / step)));
  std::size_t next = 1;
  for (int i = 0; i <= steps; ++i) {
    const double time = knots.front().time + span * i / steps;
    while (next + 1 < knots.size() && knots[next].time < time) ++next;
    points.push_back(between(knots[next - 1], knots[next], time));
  }
  return points;
}

}  // namespace

void rollOut(const TrafficGenerator& generator, std::uint64_t seed, TrafficClip& clip) {
  const TrafficOptions& options = generator.traffic();
  const torch::NoGradGuard no_gradients;
  const torch::Generator noise = noiseOf(seed);
  int now = options.history_frames - 1;
  for (AgentFrames& frames : clip.agents) frames.resize(static_cast<std::size_t>(now) + 1);
  while (now < clip.collision_frame) {
    const TrafficBatch history = batchOf({{&clip, now}}, options, 0);
    const torch::Tensor driven = generator.predict(history, noise).contiguous();
    if (!driven.isfinite().all().item<bool>()) {
      throw std::runtime_error("the generator predicts a position that is not finite");
    }
    const auto poses = driven.accessor<float, 4>();
    const torch::Tensor there = seenThroughout(history, options.history_frames);
    const Pose2 origin = *clip.agents[kEgoAgent][static_cast<std::size_t>(now)];
    for (std::size_t a = 0; a < clip.agents.size(); ++a) {
      const auto row = static_cast<long>(a);
      const bool is_there = there[0][row].item<float>() > 0.0f;
      for (long t = 0; t < options.future_frames; ++t) {
        const auto& pose = poses[0][row][t];
        clip.agents[a].push_back(
            is_there ? std::optional<Pose2>(compose(origin, {pose[0], pose[1], pose[2]}))
                     : std::nullopt);
      }
    }
    now += options.future_frames;
  }
}

Attack drivenThrough(const TrafficClip& clip, const Pose2& ego, const std::string& attacker,
                     const Moment& moment, const CollisionRequest& request, int now,
                     const AttackOptions& options) {
  const Track& track = trackOf(moment.snapshot, attacker);
  const Motion motion = estimateMotion(track);
  const double frame_time = request.tta / (clip.collision_frame - now);
  std::vector<Knot> knots = {{moment.snapshot.now, motion.pose}};
  for (int frame = now + 1; frame <= clip.collision_frame; ++frame) {
    const Pose2& pose = *clip.agents[kAttackerAgent][static_cast<std::size_t>(frame)];
    knots.push_back({moment.snapshot.now + (frame - now) * frame_time, compose(ego, pose)});
  }
  findVelocities(knots, motion);
  AttackerTrajectory trajectory{attacker, track.agent_class, track.size,
                                smoothThrough(knots, options.search.step)};
  goStraightOn(trajectory, options.search.tail, options.search.step);
  return drivenAttack(std::move(trajectory), moment, request, options);
}

GeneratorMethod::GeneratorMethod(std::shared_ptr<const TrafficGenerator> generator,
                                 const AttackOptions& options)
    : generator_(std::move(generator)), options_(options) {}

Attack GeneratorMethod::answer(const Moment& moment, const CollisionRequest& request) const {
  if (!isPublished(request.type)) {
    return rejection(
        {StatusCode::kInvalidInput,
         std::string("collision_type = \"") + toString(request.type) +
             "\" is unknown to learned generators: they know the five types of COLLIDE"});
  }
  const Snapshot& snapshot = moment.snapshot;
  const TrafficOptions& traffic = generator_->traffic();
  const Pose2 ego = estimateMotion(snapshot.ego).pose;
  return bestOfCandidates(moment, request, options_.prediction, [&](const std::string& id) {
    TrafficClip clip = trafficOf(snapshot, id, request, traffic, moment.lanes.get());
    rollOut(*generator_, request.seed, clip);
    return drivenThrough(clip, ego, id, moment, request, traffic.history_frames - 1, options_);
  });
}

std::unique_ptr<const AttackMethod> TrafficGenerator::method(const AttackOptions& options) const {
  return std::make_unique<GeneratorMethod>(
      std::static_pointer_cast<const TrafficGenerator>(shared_from_this()), options);
}

}  // namespace forge
