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
  CollisionType type = CollisionType::kRearEnd;
  std::string attacker_id;
  double time = 0.0;          ///< s, same clock as the snapshot; the time of impact
  OrientedBox ego;            ///< the ego's box at `time`, global map frame
  Pose2 attacker_offset;      ///< attacker's box centre in the frame of the ego's box centre
  double attacker_speed = 0;  ///< m/s along the attacker's heading at impact
  double tolerance = 0.0;     ///< m; a contact whose cornerMiss() is at most this counts as equal
};

/// Difference between the attacker's predicted and actual pose at contact, in the ego's frame.
struct PatternMiss {
  double distance = 0.0;  ///< m between the two box centres
  double heading = 0.0;   ///< rad between the two headings, [0, pi]
};

/// Returns the difference between two poses of the attacker that are given in the same frame.
PatternMiss missBetween(const Pose2& expected, const Pose2& actual);

/// Returns an upper bound, in m, on the displacement of any corner of the attacker's box of size
/// `attacker` between its predicted and its actual pose.
double cornerMiss(const PatternMiss& miss, const BoxSize& attacker);

/// One sample of the attacker's motion. Global map frame; the pose is the box centre.
struct TrajectoryPoint {
  double time = 0.0;  ///< seconds, same clock as the snapshot
  Pose2 pose;
  double speed = 0.0;         ///< m/s along the heading
  double acceleration = 0.0;  ///< m/s2 along the heading
  double curvature = 0.0;     ///< 1/m, positive to the left
};

/// Returns the point at `time`, with pose and speed interpolated linearly and acceleration and
/// curvature of the point before. Returns the first point up to its time and the last one from its
/// time on. `points` must not be empty and have ascending times.
TrajectoryPoint pointAt(const std::vector<TrajectoryPoint>& points, double time);

/// Converts points to states; the velocity is the speed along the heading.
std::vector<AgentState> toStates(const std::vector<TrajectoryPoint>& points);

/// The attacker's motion, evenly sampled from t0 to after the impact.
struct AttackerTrajectory {
  std::string attacker_id;
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  std::vector<TrajectoryPoint> points;
  /// Added vehicle: its states from its first frame in the recording to t0, at the frame times.
  /// Empty for a recorded vehicle, whose past is its track.
  std::vector<AgentState> past = {};

  /// Returns true for a vehicle added to the scene, false for a recorded one.
  bool isAdded() const { return !past.empty(); }
};

/// Returns the pose at `time`, interpolated linearly and clamped to the first and the last point.
/// `trajectory.points` must not be empty.
Pose2 poseAt(const AttackerTrajectory& trajectory, double time);

/// Road use of a motion. Each field but `off_road` is a share of the motion's points, [0, 1].
struct RoadUse {
  double on_lane = 0.0;     ///< on a lane in its direction, LaneGrid::isOnLane()
  double wrong_way = 0.0;   ///< on no lane and against all nearby lanes, LaneGrid::isWrongWay()
  double off_road = 0.0;    ///< mean share of the box's samples (placesOf()) off the drivable area
  double on_walkway = 0.0;  ///< a sample of the box is on a walkway and off the drivable area
  double on_island = 0.0;   ///< on ground enclosed by road, for instance a traffic island
};

/// A model of a careful and competent driver in the ego's place.
struct CarefulDrive {
  std::string driver;               ///< "cc_driver", "r157_system", "rss" or "fsm"
  bool avoids = false;              ///< this driver has no contact
  std::optional<double> brakes_at;  ///< s, scene clock; empty if this driver does not brake
};

/// Result of verifying an attacker's motion against a request; see verify().
struct CollisionReport {
  bool contact = false;               ///< the attacker touches the ego after t0
  double contact_time = 0.0;          ///< s, same clock as the snapshot; valid if `contact`
  double relative_heading = 0;        ///< rad, attacker's yaw minus ego's at contact, (-pi, pi]
  Pose2 ego_at_contact;               ///< box centre, global map frame
  Pose2 attacker_at_contact;          ///< box centre, global map frame
  Side ego_side = Side::kRear;        ///< side of the ego's box that the attacker touches
  Side attacker_side = Side::kFront;  ///< side of the attacker's box that the ego touches
  double impact_speed = 0.0;          ///< m/s, norm of the relative velocity at contact
  double overlap = 0.0;               ///< share 0..1 of `ego_side` that the attacker covers
  CrashSeverity severity;             ///< severityOf(); set by verify() if `contact`
  std::vector<CarefulDrive> careful_drivers;  ///< driveCarefully(); empty if not requested
  bool type_kept = false;       ///< keeps the definition of the requested type (CrashDefinition)
  bool on_time = false;         ///< |contact time - requested time| <= time_tolerance
  bool limits_kept = false;     ///< every vehicle limit kept from t0 to contact
  std::string broken_limit;     ///< name, value and limit of the worst violation; empty if kept
  std::string first_other_id;   ///< first other agent hit before the ego; empty if none
  double first_other_time = 0;  ///< s, same clock; valid if `first_other_id` is not empty
  double off_road_share = 0.0;  ///< mean share of the box off the drivable area, t0 to contact
  double confidence = 0.0;      ///< share of the ego's predicted futures that pass all checks, 0..1
  ContactConditions conditions;                      ///< valid if `contact`
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;  ///< detected; valid if `contact`
  double manoeuvre_begin = 0.0;                      ///< s, same clock; valid if `contact`
  /// Until contact; `on_lane` and `wrong_way` leave out the last moments before it.
  RoadUse road;
  std::string unbelievable;  ///< why drivers do not drive so; empty if the motion is plausible

  bool believable() const { return unbelievable.empty(); }
  /// Returns true if the attack counts as a success: every condition of the request holds.
  bool verified() const {
    return contact && type_kept && on_time && limits_kept && first_other_id.empty();
  }
};

/// Purpose of a support vehicle: kParkedVehicle and kLeader hide the attacker, as Hider says;
/// kQueue stands ahead of an attacker that stands in a lane.
enum class SupportRole { kParkedVehicle, kLeader, kQueue };
/// Returns "parked_vehicle", "leader" or "queue".
const char* toString(SupportRole role);
/// Returns the role of a name as toString() spells it; nullopt for another name.
std::optional<SupportRole> supportRoleFromString(const std::string& name);

/// A vehicle without contact before the crash that serves an attack.
struct SupportVehicle {
  SupportRole role = SupportRole::kParkedVehicle;
  /// As of an attacker. After the last point it stands if its speed there is 0, else it is out of
  /// sight.
  AttackerTrajectory motion;
};

inline constexpr std::size_t kMaxSupports = 16;  ///< of an attack

/// The result of a request: a verified attack, or the reason why there is none.
struct Attack {
  Status status;
  CollisionPattern pattern;  ///< predicted pattern that the attack realises; this and the next
                             ///< three fields are valid only if `status.code` is kOk
  PatternMiss miss;          ///< difference between `pattern` and the report's contact
  AttackerTrajectory trajectory;
  CollisionReport report;
  /// Penalty for unusual driving, in units of confidence: 0 for the most common behaviour. Set only
  /// if the request asks for plausible attackers.
  double effort = 0.0;
  std::vector<SupportVehicle> supports = {};  ///< agents of the scene besides the recorded ones
  /// Further attacks if the request asks for them (findAlternatives()); they have no alternatives
  /// of their own.
  std::vector<Attack> alternatives = {};
};

/// Returns a result without an attack, rejected with `status`.
Attack rejection(Status status);

}  // namespace forge
