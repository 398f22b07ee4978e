#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// Where ego and attacker stand to each other at impact (Sec. 3 of arXiv 2510.12206).
struct CollisionPattern {
  CollisionType type = CollisionType::kRearEnd;
  std::string attacker_id;
  double time = 0.0;          ///< seconds, same clock as the snapshot; the instant of impact
  OrientedBox ego;            ///< the ego's box then, global map frame
  Pose2 attacker_offset;      ///< the attacker's box centre in the ego box's frame (dx, dy, dtheta)
  double attacker_speed = 0;  ///< m/s along its heading at impact
  double tolerance = 0.0;     ///< m: a contact with every corner of the attacker so near is as good
};

/// How far a contact is from the pattern that was aimed at, both seen from the ego's box.
struct PatternMiss {
  double distance = 0.0;  ///< m between the attacker's box middles
  double heading = 0.0;   ///< rad between its headings, [0, pi]
};

/// Between the attacker's offset that was asked for and that at the contact.
PatternMiss missBetween(const Pose2& asked, const Pose2& found);

/// At most so far is any corner of the attacker's box from where it was asked to be, metres.
double cornerMiss(const PatternMiss& miss, const BoxSize& attacker);

/// One sample of the attacker's motion. Global map frame; the pose is the box centre.
struct TrajectoryPoint {
  double time = 0.0;  ///< seconds, same clock as the snapshot
  Pose2 pose;
  double speed = 0.0;         ///< m/s along the heading
  double acceleration = 0.0;  ///< m/s2 along the heading
  double curvature = 0.0;     ///< 1/m, positive to the left
};

/// The same as states, whose velocity is along the heading.
std::vector<AgentState> toStates(const std::vector<TrajectoryPoint>& points);

/// What the attacker drives from now on, evenly sampled from now to past the impact.
struct AttackerTrajectory {
  std::string attacker_id;
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::vector<TrajectoryPoint> points;
  /// Of one that was added: from its first frame in the recording to now, at the frames' times.
  /// Empty for a recorded vehicle.
  std::vector<AgentState> past = {};

  bool isAdded() const { return !past.empty(); }
};

/// The attacker's pose at `time`, linear between the points; the first before, the last after them.
/// The trajectory must have points.
Pose2 poseAt(const AttackerTrajectory& trajectory, double time);

/// What road a motion uses, as shares in [0, 1] of its points; `off_road` is the mean over them.
struct RoadUse {
  double on_lane = 0.0;     ///< see LaneGrid::isOnLane()
  double wrong_way = 0.0;   ///< on no lane, and against those that are near
  double off_road = 0.0;    ///< share of the box's places off the drivable area
  double on_walkway = 0.0;  ///< some place of the box is on a walkway and not on the drivable area
  double on_island = 0.0;   ///< on ground that road encloses
};

/// What verification found; see verify().
struct CollisionReport {
  bool contact = false;         ///< the attacker touches the ego after now
  double contact_time = 0.0;    ///< seconds, same clock; valid with contact
  double relative_heading = 0;  ///< attacker's yaw minus ego's at first contact, radians (-pi, pi]
  Pose2 ego_at_contact;
  Pose2 attacker_at_contact;
  Side ego_side = Side::kRear;        ///< of the ego's box, where the attacker's touches it
  Side attacker_side = Side::kFront;  ///< of the attacker's box, where the ego's touches it
  double impact_speed = 0.0;          ///< m/s, norm of the relative velocity at contact
  double overlap = 0.0;               ///< sideOverlap() of the ego's box at that side, [0, 1]
  bool type_kept = false;       ///< relative heading within the type's bands, at contact and now
  bool on_time = false;         ///< |contact time - requested time| within tolerance
  bool limits_kept = false;     ///< every vehicle limit kept from now to contact
  std::string broken_limit;     ///< name, value and limit of the worst broken one; empty if kept
  std::string first_other_id;   ///< whom the attacker touches before the ego; empty if nobody
  double first_other_time = 0;  ///< seconds, same clock; valid with first_other_id
  double off_road_share = 0.0;  ///< mean share of the box off the drivable area, now to contact
  double confidence = 0.0;      ///< share of likely ego futures with all conditions kept, [0, 1]
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;  ///< what it does; valid with contact
  double manoeuvre_begin = 0.0;  ///< seconds, same clock, from when on it does that
  /// What road it uses: on_lane and wrong_way until shortly before the contact, all else until it.
  RoadUse road;
  std::string unbelievable;  ///< why no driver would drive so; empty: a driver could

  bool believable() const { return unbelievable.empty(); }
  /// All conditions at once: what alone may be called a success.
  bool verified() const {
    return contact && type_kept && on_time && limits_kept && first_other_id.empty();
  }
};

/// A verified attack, or why there is none.
struct Realization {
  Status status;
  CollisionPattern aim;  ///< the pattern that it came from; these four with kOk only
  PatternMiss miss;      ///< of the report's contact from the aim
  AttackerTrajectory trajectory;
  CollisionReport report;
  /// What driving so costs, as a share of confidence: 0 as most people drive. Of believable
  /// attackers alone.
  double effort = 0.0;
  /// Further ones, where the request asks for them (findAlternatives()); these have none.
  std::vector<Realization> alternatives = {};
};

/// No attack, for this reason.
Realization declined(Status status);

}  // namespace forge
