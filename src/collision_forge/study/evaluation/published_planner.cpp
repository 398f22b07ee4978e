#include "collision_forge/study/evaluation/published_planner.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/published.h"

namespace forge {
namespace {

class ClipProtocol : public PublishedProtocol {
 public:
  ClipProtocol(CollideClip clip, const PublishedOptions& options)
      : clip_(std::move(clip)), options_(options) {}

  bool isHit(const std::vector<TrajectoryPoint>& ego) const override {
    const CollideClip driven = withEgo(clip_, ego);
    return publishedOutcome(driven, recordedFrames(driven), options_).isHit();
  }

  bool isIdmHit(const PublishedIdmOptions& idm) const override {
    std::vector<Pose2> ego;
    for (const PublishedIdmStep& step : publishedIdmDrive(clip_, idm, options_)) {
      ego.push_back(step.pose);
    }
    return publishedOutcome(clip_, recordedFrames(clip_), ego, options_).isHit();
  }

 private:
  CollideClip clip_;
  PublishedOptions options_;
};

}  // namespace

CollideClip withEgo(CollideClip clip, const std::vector<TrajectoryPoint>& driven) {
  if (driven.empty()) throw std::invalid_argument("the ego of " + clip.name + " has no motion");
  const Track ego{kEgoId, AgentClass::kCar, {}, toStates(driven)};
  for (CollideTrack& track : clip.tracks) {
    if (track.id != kEgoId) continue;
    for (std::size_t frame = 0; frame < track.frames.size(); ++frame) {
      if (clip.times[frame] < ego.states.front().time) continue;
      const AgentState state = stateAt(ego, clip.times[frame]).value_or(ego.states.back());
      track.frames[frame] = CollideState{state.pose, state.velocity.norm()};
    }
  }
  return clip;
}

CollideClip withAttacker(CollideClip clip, const AttackerTrajectory& trajectory) {
  const std::vector<Pose2> poses = framesOf(clip, trajectory);
  for (CollideTrack& track : clip.tracks) {
    if (track.id != clip.attacker_id) continue;
    for (std::size_t frame = kCollideNowFrame + 1; frame < poses.size(); ++frame) {
      const Vector2 moved = poses[frame].position() - poses[frame - 1].position();
      const double speed = moved.norm() / (clip.times[frame] - clip.times[frame - 1]);
      track.frames[frame] = CollideState{poses[frame], speed};
    }
  }
  return clip;
}

std::vector<PublishedIdmStep> publishedIdmDrive(const CollideClip& clip,
                                                const PublishedIdmOptions& idm,
                                                const PublishedOptions& protocol) {
  const std::vector<Pose2> recorded = publishedSteps(egoFrames(clip), protocol);
  const std::vector<Pose2> lead = publishedSteps(recordedFrames(clip), protocol);
  const auto steps_per_frame = static_cast<std::size_t>(protocol.steps_per_interval);
  std::vector<PublishedIdmStep> driven = {{recorded.front(), clip.ego().frames.front()->speed}};
  for (std::size_t step = 1; step < recorded.size(); ++step) {
    PublishedIdmStep next = driven.back();
    const std::size_t frame = std::min(step / steps_per_frame, clip.times.size() - 2);
    const double lead_speed = clip.attacker().frames[frame]->speed;
    const double distance = (lead[step].position() - next.pose.position()).norm();
    next.speed = publishedIdmSpeed(idm, next.speed, lead_speed, distance);
    const Vector2 moved = recorded[step].position() - recorded[step - 1].position();
    if (moved.norm() > 0.0) {
      const Vector2 way = next.speed * idm.step * moved.normalized();
      next.pose.x += way.x();
      next.pose.y += way.y();
    }
    next.pose.yaw = recorded[step].yaw;
    driven.push_back(next);
  }
  return driven;
}

std::shared_ptr<const PublishedProtocol> publishedProtocol(CollideClip clip,
                                                           const PublishedOptions& options) {
  return std::make_shared<ClipProtocol>(std::move(clip), options);
}

}  // namespace forge
