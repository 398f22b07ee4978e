#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AgentTrack.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackerPath.h>
#include <collision_forge/AttackerTrajectory.h>
#include <collision_forge/CarefulDrive.h>
#include <collision_forge/CollisionPattern.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/CrashEffect.h>
#include <collision_forge/EgoVehicle.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/Future.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/TrafficLightArray.h>
#include <collision_forge/TrajectoryPoint.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/Header.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "collision_forge/attack/network/scene_encoding.h"
#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/base/scene/scene_history.h"
#include "collision_forge/ros/messages/message_error.h"

/// Converts between the core's types and messages, field by field and in the same order:
/// fromMessage() returns the core's type, toMessage() the message. Poses and points are in the map
/// frame, and messages with a header get this frame; units as in the types. Poses are planar: z,
/// roll and pitch are dropped, and 0 in messages. Stamps are seconds on the scene's clock; times
/// (s) become stamps by stampOf(). `now`: t0, s; the stamp of the header. Lists keep their order,
/// an empty list stays empty. Numbers are not checked unless a comment says so; functions without a
/// comment on exceptions throw only as stampOf(). The message definitions (msg/, srv/) document the
/// fields.
namespace forge {

/// Throws MessageError if the frame of a message of `topic` (for the error text) is neither `map`
/// nor empty.
void requireMapFrame(const std_msgs::Header& header, const char* topic);

/// Returns a stamp with toSec() == `time` (s). A double cannot resolve nanoseconds at Unix times,
/// so the stamp is rounded to a whole microsecond, which restores the stamps of nuScenes, unless
/// toSec() would then differ. Throws std::runtime_error as ros::Time for a time out of its range.
ros::Time stampOf(double time);

/// The yaw is in [-pi, pi], and NaN for a quaternion that is not finite. A Pose2D's yaw is copied.
Pose2 fromMessage(const geometry_msgs::Pose& message);
Pose2 fromMessage(const geometry_msgs::Pose2D& message);
Pose2 fromMessage(const geometry_msgs::Transform& message);
geometry_msgs::Pose toPoseMessage(const Pose2& pose);
/// Sets x, y and yaw of `pose`; height, roll and pitch are kept.
void setPlanar(const Pose2& planar, geometry_msgs::Pose& pose);
geometry_msgs::Pose2D toPose2dMessage(const Pose2& pose);

/// Returns x: length, y: width, z: 0.
geometry_msgs::Vector3 toMessage(const BoxSize& size);
/// Returns the size of the ego's box (m); nullopt unless both numbers are finite and above 0.
std::optional<BoxSize> egoSizeOf(const collision_forge::EgoVehicle& message);
TrajectoryPoint fromMessage(const collision_forge::TrajectoryPoint& message);
collision_forge::TrajectoryPoint toMessage(const TrajectoryPoint& point);

/// A speed limit of 0 or less is none; any driving side but DRIVE_LEFT is right. Throws
/// MessageError for an unknown kind of map feature.
LaneMap fromMessage(const collision_forge::LaneMap& message);
/// `stamp`: stamp of the header. Corners of polygons become float32, relative to the message's
/// `origin`: an error below 1 mm within 6 km of it.
collision_forge::LaneMap toMessage(const LaneMap& map, const ros::Time& stamp);

/// Returns one light with one state, at the stamp of the header, per light of the message. Throws
/// MessageError for an unknown colour.
std::vector<TrafficLight> fromMessage(const collision_forge::TrafficLightArray& message);
/// Returns all lights with their colours at `stamp` (colorAt()).
collision_forge::TrafficLightArray toMessage(const std::vector<TrafficLight>& lights,
                                             const ros::Time& stamp);

/// Returns one track with one state, at the stamp of the header, per agent. Throws MessageError for
/// an unknown agent class.
std::vector<Track> fromMessage(const collision_forge::AgentArray& message);

AgentState fromMessage(const collision_forge::TrackState& message);
collision_forge::TrackState toMessage(const AgentState& state);

/// Throws MessageError for an unknown agent class.
Track fromMessage(const collision_forge::AgentTrack& message);
collision_forge::AgentTrack toMessage(const Track& track);

/// Throws MessageError for an unknown agent class.
Future fromMessage(const collision_forge::Future& message);
collision_forge::Future toMessage(const Future& future);

/// Returns the snapshot at t0 = the stamp of the header, with a null map. Throws MessageError for
/// an unknown agent class.
Snapshot fromMessage(const collision_forge::SceneSnapshot& message);
/// The message has no map.
collision_forge::SceneSnapshot toMessage(const Snapshot& snapshot);
/// `encoding`: the encoding of `snapshot`; EncodedScene.msg documents the axes of the tensors.
collision_forge::EncodedScene toMessage(const Snapshot& snapshot, const SceneEncoding& encoding);

/// Returns the request, or a Status with kUnknownType (also for an empty type) or kInvalidInput and
/// the field and value at fault; checkRequest() checks the numbers. An empty mode is history; a
/// seed or number of alternatives of 0 is the default of CollisionRequest; `believable` and
/// `limits`, if empty, and the rest of the crash definition come from `crash`. Ranges with both
/// bounds 0 allow any value. Adaptive requests have no minimum confidence, because only the first
/// plan is known.
std::variant<CollisionRequest, Status> fromMessage(const collision_forge::CollisionRequest& message,
                                                   const CrashDefinition& crash);
/// Returns `request` with the message's mode (empty: history; adaptive: minimum confidence 0) and
/// the other fields that the message sets to something else than empty or 0; the type stays,
/// whatever the message has. Returns kInvalidInput as fromMessage().
std::variant<CollisionRequest, Status> withFieldsOf(
    const collision_forge::CollisionRequest& message, CollisionRequest request);
/// Writes every field that a request sets, defaults included (an unset constraint is "" or 0); of
/// the crash definition only `believable` and `limits`.
collision_forge::CollisionRequest toMessage(const CollisionRequest& request);
/// Returns the fields of a request of generate_collision that CollisionRequest.msg has, unchecked:
/// not `name`, `text`, `method`, `alternative` and `stamp`. Mode history with `adaptive` set
/// becomes mode adaptive.
collision_forge::CollisionRequest requestIn(
    const collision_forge::GenerateCollision::Request& message);

/// The time is the stamp of the header plus `tta`. Throws MessageError for an unknown collision
/// type.
CollisionPattern fromMessage(const collision_forge::CollisionPattern& message);
collision_forge::CollisionPattern toMessage(const CollisionPattern& pattern, double now);

/// Returns the path along which an attacker drives. Throws MessageError for a path that the
/// constructor of ReferencePath rejects.
ReferencePath fromMessage(const collision_forge::AttackerPath& message);
collision_forge::AttackerPath toMessage(const ReferencePath& way, const std::string& attacker_id);

/// Returns true for the empty attack (without an attacker's id), which is published when an attack
/// has ended.
inline bool isNone(const collision_forge::Attack& attack) {
  return attack.trajectory.attacker_id.empty();
}

/// Throws MessageError for an unknown agent class, a size that is not finite and > 0, non-finite
/// points or past states, times that do not increase, and a past that contradicts `added`
/// (added without a past, or a past without added). A trajectory without points is accepted.
AttackerTrajectory fromMessage(const collision_forge::AttackerTrajectory& message);
/// The header's stamp is the time of the first point, t0; 0 without points.
collision_forge::AttackerTrajectory toMessage(const AttackerTrajectory& trajectory);

collision_forge::CrashEffect toMessage(const CrashEffect& effect);
collision_forge::CarefulDrive toMessage(const CarefulDrive& drive);

/// Fields that CollisionReport marks as valid only with a contact stay 0 or empty without one.
collision_forge::CollisionReport toMessage(const CollisionReport& report,
                                           const std::string& attacker_id, double now);

/// Throws MessageError for an unknown side, manoeuvre or hider, if there is a contact. Ignores
/// `verified` and `believable`, which follow from the other fields.
CollisionReport fromMessage(const collision_forge::CollisionReport& message);

/// Returns an attack with kOk and without alternatives; the fields about plans (adaptive, phase,
/// decision, decided, plans) have no counterpart. Throws like fromMessage() of pattern,
/// trajectory and report, and MessageError for an unknown role of a support vehicle.
Attack fromMessage(const collision_forge::Attack& message);
/// `answer` must have the status kOk; its alternatives are left out. `method`: name of the method.
/// The attack is not marked as adaptive (setPlans()).
collision_forge::Attack toMessage(const Attack& answer, const std::string& method, double now);

/// Marks an attack as adaptive and sets its phase, its last decision (also in its report) with its
/// time, and the number of plans, from `plans`, the result of AttackerPolicy::plans() in order of
/// time. `plans` must not be empty.
void setPlans(const std::vector<AttackerPlan>& plans, collision_forge::Attack& message);

}  // namespace forge
