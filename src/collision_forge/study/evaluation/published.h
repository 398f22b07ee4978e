#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The outcome of one clip in the protocol of the paper.
struct PublishedOutcome {
  enum class Event {
    kNone,           ///< no collision
    kHit,            ///< ego and attacker collide
    kAttackerOther,  ///< attacker and another agent collide: a miss
    kEgoOther,       ///< ego and another agent collide: a miss
  };
  Event event = Event::kNone;  ///< the first collision, which ends the clip
  int step = 0;  ///< index of the event's step in publishedSteps(), 0 at frame 0; 0 with kNone
  std::string other_id;  ///< the attacker with kHit, else the other agent; empty with kNone
  /// rad in [0, pi], |angle| between the headings of ego and attacker; only with kHit.
  double relative_heading = 0.0;
  bool similar = false;  ///< true: a hit that is similar by rule 4 of publishedOutcome()

  /// Returns true if ego and attacker are the first to collide.
  bool isHit() const { return event == Event::kHit; }
};

/// Evaluates a clip by the protocol of arXiv 2510.12206, as the published figures were measured.
/// The protocol tests the whole clip, history included, at fixed steps, and limits neither the
/// attacker's motion nor the time of impact.
///
/// 1. Steps: each interval between two frames has `steps_per_interval` steps with linear positions
///    and the heading of the interval's start. From the last frame on, `steps_after` steps continue
///    straight with the step length of the last interval and the heading of the frame before the
///    last. An agent that is missing at either end of an interval is absent in that interval.
/// 2. Two boxes collide if their intersection over union is above `min_overlap`.
/// 3. Steps are tested in order, and in each step the agents in order of their ids: the attacker
///    against the ego; every other agent against the attacker, then against the ego. The first
///    collision ends the clip. It is a hit only if ego and attacker collide.
/// 4. A hit is similar if its |relative heading| differs by less than `similar_heading` from the
///    angle in the file name.
///
/// `attacker`: its pose (map frame) in each frame of the clip, 0 to collision_frame, as recorded up
/// to t0. Throws std::invalid_argument for another number of poses.
PublishedOutcome publishedOutcome(const CollideClip& clip, const std::vector<Pose2>& attacker,
                                  const PublishedOptions& options);

/// Evaluates a clip with another ego motion: `ego` is its pose (map frame) at each step of
/// publishedSteps(). Throws std::invalid_argument for another number of poses of either vehicle.
PublishedOutcome publishedOutcome(const CollideClip& clip, const std::vector<Pose2>& attacker,
                                  const std::vector<Pose2>& ego, const PublishedOptions& options);

/// Returns the poses at the steps of rule 1, steps_per_interval * (frames - 1) + steps_after of
/// them, for an agent with a pose in each frame (at least two frames).
std::vector<Pose2> publishedSteps(const std::vector<Pose2>& frames,
                                  const PublishedOptions& options);

/// Returns the recorded pose (map frame) of the ego in each frame of the clip.
std::vector<Pose2> egoFrames(const CollideClip& clip);

}  // namespace forge
