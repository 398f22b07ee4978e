#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/crash_severity.h"
#include "collision_forge/base/scene/manoeuvre.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// The poses, speed and time at impact that a method predicts (Sec. 3 of arXiv 2510.12206).
struct CollisionPattern {
  /// The requested type; for a request with kAny the type that was chosen.
  CollisionType type = CollisionType::kRearEnd;
  std::string attacker_id;    ///< id of the recorded or added vehicle that attacks
  double time = 0.0;          ///< s, same clock as the snapshot; the time of impact
  OrientedBox ego;            ///< the ego's box at `time`, global map frame
  Pose2 attacker_offset;      ///< attacker's box centre in the frame of the ego's box centre
  double attacker_speed = 0;  ///< m/s along the attacker's heading at impact
  /// m; a contact whose cornerMiss() from this pattern is at most this counts as the predicted one.
  double tolerance = 0.0;
};

/// Difference between the attacker's predicted and actual pose at contact, in the ego's frame.
struct PatternMiss {
  double distance = 0.0;  ///< m between the two box centres
  double heading = 0.0;   ///< rad between the two headings, [0, pi]
};

/// Returns the difference between two poses of the attacker that are given in the same frame.
PatternMiss missBetween(const Pose2& expected, const Pose2& actual);

/// Returns an upper bound, in m, on the displacement of any corner of the attacker's box of size
/// `attacker` between its predicted and its actual pose: miss.distance + circumradius(attacker) *
/// miss.heading.
double cornerMiss(const PatternMiss& miss, const BoxSize& attacker);

/// One sample of the attacker's motion. Global map frame; the pose is the box centre.
struct TrajectoryPoint {
  double time = 0.0;  ///< seconds, same clock as the snapshot
  Pose2 pose;
  double speed = 0.0;         ///< m/s along the heading, negative: backwards
  double acceleration = 0.0;  ///< m/s2 along the heading, negative: braking
  double curvature = 0.0;     ///< 1/m, positive to the left
};

/// Returns the point at `time` (s, clock of the points), with pose and speed interpolated linearly
/// and acceleration and curvature of the point before. Returns the first point, with its own time,
/// for an earlier `time`, and the last point for a later one. `points` must not be empty and have
/// ascending times.
TrajectoryPoint pointAt(const std::vector<TrajectoryPoint>& points, double time);

/// Converts points to states of the same times and poses; the velocity is the speed along the
/// heading.
std::vector<AgentState> toStates(const std::vector<TrajectoryPoint>& points);

/// The attacker's motion from t0 to some time after the impact (SearchOptions::tail), by default
/// every 0.1 s (SearchOptions::step). Poses are box centres in the global map frame.
struct AttackerTrajectory {
  std::string attacker_id;  ///< id of the recorded agent, or a new id of an added vehicle
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::vector<TrajectoryPoint> points;  ///< ascending times, the first one t0
  /// Added vehicle: its states from its first frame in the recording up to t0 (included), at the
  /// frame times. Empty for a recorded vehicle, whose past is its track.
  std::vector<AgentState> past = {};

  /// Returns true for a vehicle added to the scene, false for a recorded one.
  bool isAdded() const { return !past.empty(); }
};

/// Returns the pose at `time` (s, clock of the points), interpolated linearly and clamped to the
/// first and the last point. `trajectory.points` must not be empty.
Pose2 poseAt(const AttackerTrajectory& trajectory, double time);

/// Road use of a motion; see roadUse(). Each field but `off_road` is the share, [0, 1], of the
/// motion's points at which the condition holds. Shares for which the map lacks a layer are 0.
struct RoadUse {
  double on_lane = 0.0;    ///< on a lane in its direction, LaneGrid::isOnLane()
  double wrong_way = 0.0;  ///< on no lane and against all nearby lanes, LaneGrid::isWrongWay()
  /// Mean share of the box's samples (samplePointsOf()) off the drivable area.
  double off_road = 0.0;
  double on_walkway = 0.0;  ///< a sample of the box is on a walkway and off the drivable area
  double on_island = 0.0;   ///< on ground enclosed by road, for instance a traffic island
};

/// A model of a careful and competent driver in the ego's place.
struct CarefulDrive {
  std::string driver;   ///< "cc_driver", "r157_system", "rss" or "fsm"
  bool avoids = false;  ///< this driver has no contact with the attacker
  /// s, scene clock: when braking begins; empty if this driver does not brake.
  std::optional<double> brakes_at;
};

/// Result of verifying an attacker's motion against a request; see verify(), which sets all fields
/// but `careful_drivers` and `confidence`. Poses, sides, speed, overlap and severity are valid if
/// `contact`.
struct CollisionReport {
  bool contact = false;  ///< the attacker touches the ego after t0; false if they overlap at t0
  /// s, same clock as the snapshot, of the first touch; valid if `contact`.
  double contact_time = 0.0;
  double relative_heading = 0;        ///< rad, attacker's yaw minus ego's at contact, (-pi, pi]
  Pose2 ego_at_contact;               ///< box centre, global map frame
  Pose2 attacker_at_contact;          ///< box centre, global map frame
  Side ego_side = Side::kRear;        ///< side of the ego's box that the attacker touches
  Side attacker_side = Side::kFront;  ///< side of the attacker's box that the ego touches
  double impact_speed = 0.0;          ///< m/s, norm of the relative velocity at contact
  double overlap = 0.0;               ///< share 0..1 of `ego_side` that the attacker covers
  CrashSeverity severity;             ///< severityOf(); set by verify() if `contact`
  std::vector<CarefulDrive> careful_drivers;  ///< driveCarefully(); empty if not requested
  /// The contact meets the definition of the requested type (CrashDefinition); false without
  /// contact.
  bool type_kept = false;
  bool on_time = false;  ///< |contact time - (t0 + TTA)| <= time_tolerance; false without contact
  /// Every vehicle limit kept from t0 to contact; if there is no contact, to the last point.
  bool limits_kept = false;
  std::string broken_limit;     ///< name, value and limit of the worst violation; empty if kept
  std::string first_other_id;   ///< first other agent that the attacker touches before the ego,
                                ///< without contact up to its last point; empty if none
  double first_other_time = 0;  ///< s, same clock; valid if `first_other_id` is not empty
  /// Mean share of the attacker's box off the drivable area, from t0 to contact; if there is no
  /// contact, to the last point. 0 if the map has no drivable area.
  double off_road_share = 0.0;
  double confidence = 0.0;  ///< confidenceOf() the share of the ego's held-out predicted futures in
                            ///< which the attack meets the request, 0..1; 1 if the future is known
  ContactConditions conditions;                      ///< valid if `contact`
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;  ///< detected; valid if `contact`
  double manoeuvre_begin = 0.0;  ///< s, same clock: start of `manoeuvre`; valid if `contact`
  /// Of the attacker from t0 to contact, roadUseOfAttack(): `on_lane` and `wrong_way` end before
  /// the attacking manoeuvre (BelievabilityOptions::before_contact, pull_out). Valid if `contact`.
  RoadUse road;
  /// Why the motion is implausible, worded to follow the attacker ("is on a walkway for 12 %");
  /// empty if it is plausible or not judged (no contact).
  std::string unbelievable;

  /// Returns true if the motion is plausible.
  bool believable() const { return unbelievable.empty(); }
  /// Returns true if the five conditions of a verified crash hold: contact, type, time, limits, and
  /// no other agent touched before. Does not include plausibility and further constraints; see
  /// meetsRequest().
  bool verified() const {
    return contact && type_kept && on_time && limits_kept && first_other_id.empty();
  }
};

/// Purpose of a support vehicle.
enum class SupportRole {
  kParkedVehicle,  ///< hides the attacker, Hider::kParkedVehicle
  kLeader,         ///< hides the attacker, Hider::kLeader
  kQueue           ///< stands ahead of an attacker that stands in its lane
};
/// Returns "parked_vehicle", "leader" or "queue".
const char* toString(SupportRole role);
/// Returns the role of a name as toString() spells it; nullopt for another name.
std::optional<SupportRole> supportRoleFromString(const std::string& name);

/// A vehicle without contact before the crash that serves an attack.
struct SupportVehicle {
  SupportRole role = SupportRole::kParkedVehicle;  ///< purpose of the vehicle
  /// Id, class, size, points and past of the support, as for an attacker. After the last point the
  /// support stands if its speed there is 0, else it is no longer part of the scene.
  AttackerTrajectory motion;
};

inline constexpr std::size_t kMaxSupports = 16;  ///< largest number of supports of an attack

/// The result of a request: a verified attack, or the reason why there is none.
struct Attack {
  Status status;             ///< kOk: a verified attack; else why there is none
  CollisionPattern pattern;  ///< predicted pattern that the attack realises; this and the next
                             ///< three fields are valid only if `status.code` is kOk
  PatternMiss miss;  ///< difference between the attacker's pose in `pattern` and at the report's
                     ///< contact, both relative to the ego
  AttackerTrajectory trajectory;
  CollisionReport report;  ///< of `trajectory`, in the predicted future in which it was verified,
                           ///< or against the recorded one if that is known
  /// Penalty for unusual driving, subtracted from the confidence to rank attacks (scoreOf()): 0 for
  /// the most common behaviour, and if the request does not ask for plausible attackers.
  double effort = 0.0;
  /// Vehicles that hide the attacker or stand ahead of it, added to the recorded agents; empty
  /// unless the request has `hidden_by` or `queue`.
  std::vector<SupportVehicle> supports = {};
  /// Further attacks if the request asks for more than one (findAlternatives()), without this one;
  /// they have no alternatives of their own.
  std::vector<Attack> alternatives = {};
};

/// Returns a result without an attack, rejected with `status`; all other fields have their
/// defaults.
Attack rejection(Status status);

}  // namespace forge
