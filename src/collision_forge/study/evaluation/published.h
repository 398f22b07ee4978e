#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// What the paper's protocol sees in one clip.
struct PublishedOutcome {
  enum class Event {
    kNone,           ///< nothing happens
    kHit,            ///< the ego and the clip's attacker
    kAttackerOther,  ///< the attacker and somebody else: a miss
    kEgoOther,       ///< the ego and somebody else: a miss
  };
  Event event = Event::kNone;     ///< the first one; it ends the clip
  int step = 0;                   ///< at which it happens, from frame 0; these three with an event
  std::string other_id;           ///< whom the attacker or the ego touches, the ego aside
  double relative_heading = 0.0;  ///< rad in [0, pi], ego to attacker; with a hit
  bool similar = false;           ///< a hit at about the angle of the file's name

  bool isHit() const { return event == Event::kHit; }
};

/// The protocol of arXiv 2510.12206, as the published figures were measured. It looks at the whole
/// clip, history included, at a fixed number of steps, and limits neither the attacker's motion nor
/// the time of impact.
///
/// 1. Steps. The interval between two frames is cut into `steps_per_interval` steps: positions
///    linear, the heading held from the interval's start. The last frame and those after it,
///    `steps_after` in all, go straight on by the last interval's steps, with the heading of the
///    frame before the last. Who is missing at either end of an interval is not there in it.
/// 2. Two boxes collide where their shared area over their joint area is above `min_overlap`.
/// 3. All steps are looked at in order, and in a step the others in the order of their ids: the
///    attacker against the ego; anybody else against the attacker, then against the ego. The first
///    collision ends the clip. It is a hit only if it is the attacker's with the ego: an ego that
///    collides with a third vehicle first makes a miss.
/// 4. A hit is similar if its |relative heading| is less than `similar_heading` away from the angle
///    in the file's name.
///
/// `attacker` holds the attacker's pose in every frame, 0 to collision_frame; those up to now as
/// recorded. Throws std::invalid_argument for another number of poses.
PublishedOutcome publishedOutcome(const CollideClip& clip, const std::vector<Pose2>& attacker,
                                  const PublishedOptions& options);

/// The same with an ego that drives as given: `ego` is its pose at every step. Throws
/// std::invalid_argument for another number of these, too.
PublishedOutcome publishedOutcome(const CollideClip& clip, const std::vector<Pose2>& attacker,
                                  const std::vector<Pose2>& ego, const PublishedOptions& options);

/// The steps of rule 1 of somebody who is there in every frame.
std::vector<Pose2> publishedSteps(const std::vector<Pose2>& frames,
                                  const PublishedOptions& options);

/// The ego's pose in every frame.
std::vector<Pose2> egoFrames(const CollideClip& clip);

}  // namespace forge
