#include "collision_forge/study/evaluation/published.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {
namespace {

using Event = PublishedOutcome::Event;
using Frames = std::vector<std::optional<Pose2>>;
using Steps = std::vector<std::optional<Pose2>>;

struct Other {
  std::string id;
  Steps steps;
};

/// Returns the pose at step `step` of an interval: linear position, extrapolated beyond the end,
/// and the heading of the start.
Pose2 stepped(const Pose2& start, const Pose2& end, double step, double steps_per_interval) {
  const Vector2 position =
      start.position() + step / steps_per_interval * (end.position() - start.position());
  return {position.x(), position.y(), start.yaw};
}

Steps stepsOf(const Frames& frames, const PublishedOptions& options) {
  Steps steps;
  const auto add = [&](std::size_t interval, int first, int count) {
    const auto& start = frames[interval];
    const auto& end = frames[interval + 1];
    for (int step = first; step < first + count; ++step) {
      if (start && end) {
        steps.push_back(stepped(*start, *end, step, options.steps_per_interval));
      } else {
        steps.push_back(std::nullopt);
      }
    }
  };
  for (std::size_t interval = 0; interval + 1 < frames.size(); ++interval) {
    add(interval, 0, options.steps_per_interval);
  }
  add(frames.size() - 2, options.steps_per_interval, options.steps_after);
  return steps;
}

Frames framesOf(const CollideTrack& track) {
  Frames frames;
  for (const auto& state : track.frames) {
    frames.push_back(state ? std::optional<Pose2>(state->pose) : std::nullopt);
  }
  return frames;
}

/// Returns all agents except the ego, sorted by id; the attacker has the given poses.
std::vector<Other> othersOf(const CollideClip& clip, const std::vector<Pose2>& attacker,
                            const PublishedOptions& options) {
  std::vector<Other> others;
  const std::string& ego_id = clip.ego().id;
  for (const CollideTrack& track : clip.tracks) {
    if (track.id == ego_id) continue;
    const Frames frames =
        track.id == clip.attacker_id ? Frames(attacker.begin(), attacker.end()) : framesOf(track);
    others.push_back({track.id, stepsOf(frames, options)});
  }
  std::sort(others.begin(), others.end(),
            [](const Other& a, const Other& b) { return a.id < b.id; });
  return others;
}

bool collide(const Pose2& a, const Pose2& b, const PublishedOptions& options) {
  const double reach = 2.0 * circumradius(options.box);
  if ((a.position() - b.position()).squaredNorm() > reach * reach) return false;
  return intersectionOverUnion({a, options.box}, {b, options.box}) > options.min_overlap;
}

/// Tests one agent (the attacker if `is_attacker`) against ego and attacker in one step.
Event eventWith(bool is_attacker, const Pose2& other, const Pose2& ego, const Pose2& attacker,
                const PublishedOptions& options) {
  if (is_attacker) return collide(ego, attacker, options) ? Event::kHit : Event::kNone;
  if (collide(attacker, other, options)) return Event::kAttackerOther;
  return collide(ego, other, options) ? Event::kEgoOther : Event::kNone;
}

}  // namespace

std::vector<Pose2> publishedSteps(const std::vector<Pose2>& frames,
                                  const PublishedOptions& options) {
  std::vector<Pose2> steps;
  for (const auto& step : stepsOf(Frames(frames.begin(), frames.end()), options)) {
    steps.push_back(*step);
  }
  return steps;
}

std::vector<Pose2> egoFrames(const CollideClip& clip) {
  std::vector<Pose2> frames;
  for (const auto& state : clip.ego().frames) frames.push_back(state->pose);
  return frames;
}

PublishedOutcome publishedOutcome(const CollideClip& clip, const std::vector<Pose2>& attacker,
                                  const PublishedOptions& options) {
  return publishedOutcome(clip, attacker, publishedSteps(egoFrames(clip), options), options);
}

PublishedOutcome publishedOutcome(const CollideClip& clip, const std::vector<Pose2>& attacker,
                                  const std::vector<Pose2>& ego, const PublishedOptions& options) {
  if (attacker.size() != clip.times.size()) {
    throw std::invalid_argument(clip.name + ": " + std::to_string(attacker.size()) +
                                " poses of the attacker for " + std::to_string(clip.times.size()) +
                                " frames");
  }
  const std::vector<Pose2> attacking = publishedSteps(attacker, options);
  if (ego.size() != attacking.size()) {
    throw std::invalid_argument(clip.name + ": " + std::to_string(ego.size()) +
                                " poses of the ego for " + std::to_string(attacking.size()) +
                                " steps");
  }
  const std::vector<Other> others = othersOf(clip, attacker, options);
  PublishedOutcome outcome;
  for (std::size_t step = 0; step < ego.size(); ++step) {
    for (const Other& other : others) {
      if (!other.steps[step]) continue;
      outcome.event = eventWith(other.id == clip.attacker_id, *other.steps[step], ego[step],
                                attacking[step], options);
      if (outcome.event == Event::kNone) continue;
      outcome.step = static_cast<int>(step);
      outcome.other_id = other.id;
      if (outcome.isHit()) {
        outcome.relative_heading = std::abs(angleBetween(ego[step].yaw, attacking[step].yaw));
        outcome.similar = std::abs(outcome.relative_heading - clip.angle) < options.similar_heading;
      }
      return outcome;
    }
  }
  return outcome;
}

}  // namespace forge
