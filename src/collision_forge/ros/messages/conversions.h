#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AgentTrack.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <collision_forge/AttackerWay.h>
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
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "collision_forge/attack/network/scene_encoding.h"
#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/base/scene/scene_history.h"

/// Converts between the core's types and messages, field by field: fromMessage() returns the core's
/// type, toMessage() the message. Poses are planar: z, roll and pitch are dropped, and 0 in
/// messages. Times (s) become stamps by stampOf(). Numbers are not checked unless a comment says
/// so.
namespace forge {

/// Thrown for an invalid message; the text has field and value.
struct MessageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MessageError if the frame of a message of `topic` is neither `map` nor empty.
void requireMapFrame(const std_msgs::Header& header, const char* topic);

/// Returns a stamp with toSec() == `time`. A double cannot resolve nanoseconds at Unix times, so
/// the stamp is rounded to a whole microsecond, which restores the stamps of nuScenes.
ros::Time stampOf(double time);

Pose2 fromMessage(const geometry_msgs::Pose& message);
Pose2 fromMessage(const geometry_msgs::Pose2D& message);
Pose2 fromMessage(const geometry_msgs::Transform& message);
geometry_msgs::Pose toPoseMessage(const Pose2& pose);
/// Sets x, y and yaw of `pose`; height, roll and pitch are kept.
void setPlanar(const Pose2& planar, geometry_msgs::Pose& pose);
geometry_msgs::Pose2D toPose2dMessage(const Pose2& pose);

geometry_msgs::Vector3 toMessage(const BoxSize& size);
/// Returns the size of the ego's box (m); nullopt unless both numbers are finite and above 0.
std::optional<BoxSize> egoSizeOf(const collision_forge::EgoVehicle& message);
TrajectoryPoint fromMessage(const collision_forge::TrajectoryPoint& message);
collision_forge::TrajectoryPoint toMessage(const TrajectoryPoint& point);

LaneMap fromMessage(const collision_forge::LaneMap& message);
collision_forge::LaneMap toMessage(const LaneMap& map, const ros::Time& stamp);

/// Returns one light with one state per light of the message. Throws MessageError for an unknown
/// colour.
std::vector<TrafficLight> fromMessage(const collision_forge::TrafficLightArray& message);
/// Returns the colours at `stamp`.
collision_forge::TrafficLightArray toMessage(const std::vector<TrafficLight>& lights,
                                             const ros::Time& stamp);

/// Returns one track with one state per agent. Throws MessageError for an unknown agent class.
std::vector<Track> fromMessage(const collision_forge::AgentArray& message);

AgentState fromMessage(const collision_forge::TrackState& message);
collision_forge::TrackState toMessage(const AgentState& state);

Track fromMessage(const collision_forge::AgentTrack& message);
collision_forge::AgentTrack toMessage(const Track& track);

Future fromMessage(const collision_forge::Future& message);
collision_forge::Future toMessage(const Future& future);

/// Returns the snapshot, without a map.
Snapshot fromMessage(const collision_forge::SceneSnapshot& message);
collision_forge::SceneSnapshot toMessage(const Snapshot& snapshot);
collision_forge::EncodedScene toMessage(const Snapshot& snapshot, const SceneEncoding& encoding);

/// Returns the request, or UNKNOWN_TYPE or INVALID_INPUT with a reason. An empty mode is history;
/// empty fields of the crash definition come from `crash`. Adaptive requests have no minimum
/// confidence, because only the first plan is known.
std::variant<CollisionRequest, Status> fromMessage(const collision_forge::CollisionRequest& message,
                                                   const CrashDefinition& crash);
/// Fills in every field, defaults included.
/// Returns `request` with the mode and the other fields that the message sets; its type stays.
/// Returns INVALID_INPUT as fromMessage().
std::variant<CollisionRequest, Status> withFieldsOf(
    const collision_forge::CollisionRequest& message, CollisionRequest request);
collision_forge::CollisionRequest toMessage(const CollisionRequest& request);
/// Returns the request of generate_collision without its method. Mode history with `adaptive` set
/// becomes mode adaptive.
collision_forge::CollisionRequest requestIn(
    const collision_forge::GenerateCollision::Request& message);

CollisionPattern fromMessage(const collision_forge::CollisionPattern& message);
collision_forge::CollisionPattern toMessage(const CollisionPattern& pattern, double now);

/// Throws MessageError for an invalid path.
ReferencePath fromMessage(const collision_forge::AttackerWay& message);
collision_forge::AttackerWay toMessage(const ReferencePath& way, const std::string& attacker_id);

/// Returns true for the empty attack, which is published when an attack has ended.
inline bool isNone(const collision_forge::Attack& attack) {
  return attack.trajectory.attacker_id.empty();
}

/// Throws MessageError for an unknown agent class, a size <= 0, non-finite points or past states,
/// times that do not increase, and a past that contradicts `added`.
AttackerTrajectory fromMessage(const collision_forge::AttackerTrajectory& message);
collision_forge::AttackerTrajectory toMessage(const AttackerTrajectory& trajectory);

collision_forge::CrashEffect toMessage(const CrashEffect& effect);
collision_forge::CarefulDrive toMessage(const CarefulDrive& drive);

collision_forge::CollisionReport toMessage(const CollisionReport& report,
                                           const std::string& attacker_id, double now);

/// Throws MessageError for an unknown side or manoeuvre. Ignores `verified` and `believable`, which
/// follow from the other fields.
CollisionReport fromMessage(const collision_forge::CollisionReport& message);

/// Returns a result with kOk and without alternatives. Throws like fromMessage() of pattern,
/// trajectory and report.
Attack fromMessage(const collision_forge::Attack& message);
/// `answer` must have the status kOk. `now`: t0, s.
collision_forge::Attack toMessage(const Attack& answer, const std::string& method, double now);

/// Marks an attack as adaptive and sets its phase and last decision. `plans` must not be empty.
void setPlans(const std::vector<AttackerPlan>& plans, collision_forge::Attack& message);

}  // namespace forge
