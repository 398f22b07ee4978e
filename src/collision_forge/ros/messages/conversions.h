#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AgentTrack.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <collision_forge/AttackerWay.h>
#include <collision_forge/CollisionPattern.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/Future.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/TrajectoryPoint.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <std_msgs/Header.h>

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

/// Conversions between the core's types and the messages. Poses are planar: z, roll and pitch are
/// dropped.
namespace forge {

/// Thrown for a message with an invalid value; names the field and the value.
struct MessageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MessageError if the frame of a message of `topic` is not `map`. An empty frame counts as
/// `map`.
void requireMapFrame(const std_msgs::Header& header, const char* topic);

/// Returns the stamp of `time`, s, with toSec() == time. A double cannot hold the nanoseconds of
/// today's times: from the stamps with the same toSec(), returns the one at a whole microsecond,
/// which restores the stamps of nuScenes.
ros::Time stampOf(double time);

Pose2 fromMessage(const geometry_msgs::Pose& message);
Pose2 fromMessage(const geometry_msgs::Pose2D& message);
Pose2 fromMessage(const geometry_msgs::Transform& message);
geometry_msgs::Pose toPoseMessage(const Pose2& pose);
/// Sets x, y and yaw of `pose`; keeps height, roll and pitch.
void setPlanar(const Pose2& planar, geometry_msgs::Pose& pose);
geometry_msgs::Pose2D toPose2dMessage(const Pose2& pose);

geometry_msgs::Vector3 toMessage(const BoxSize& size);
TrajectoryPoint fromMessage(const collision_forge::TrajectoryPoint& message);
collision_forge::TrajectoryPoint toMessage(const TrajectoryPoint& point);

LaneMap fromMessage(const collision_forge::LaneMap& message);
collision_forge::LaneMap toMessage(const LaneMap& map, const ros::Time& stamp);

/// Returns a track with one state for each agent. Throws MessageError for an unknown agent class.
std::vector<Track> fromMessage(const collision_forge::AgentArray& message);

AgentState fromMessage(const collision_forge::TrackState& message);
collision_forge::TrackState toMessage(const AgentState& state);

Track fromMessage(const collision_forge::AgentTrack& message);
collision_forge::AgentTrack toMessage(const Track& track);

Future fromMessage(const collision_forge::Future& message);
collision_forge::Future toMessage(const Future& future);

/// Returns the snapshot without a map.
Snapshot fromMessage(const collision_forge::SceneSnapshot& message);
collision_forge::SceneSnapshot toMessage(const Snapshot& snapshot);
collision_forge::EncodedScene toMessage(const Snapshot& snapshot, const SceneEncoding& encoding);

/// Returns the request, or UNKNOWN_TYPE or INVALID_INPUT with a message. An empty mode is history.
/// `crash` gives the crash definition where the message leaves it open. For an adaptive attacker
/// the first plan needs no minimum confidence.
std::variant<CollisionRequest, Status> fromMessage(const collision_forge::CollisionRequest& message,
                                                   const CrashDefinition& crash);
/// Fills in all words, defaults included.
collision_forge::CollisionRequest toMessage(const CollisionRequest& request);
/// Returns the CollisionRequest in a request of generate_collision, without the method. Mode
/// history with `adaptive` becomes mode adaptive.
collision_forge::CollisionRequest requestIn(
    const collision_forge::GenerateCollision::Request& message);

CollisionPattern fromMessage(const collision_forge::CollisionPattern& message);
collision_forge::CollisionPattern toMessage(const CollisionPattern& pattern, double now);

/// Throws MessageError for an invalid path.
ReferencePath fromMessage(const collision_forge::AttackerWay& message);
collision_forge::AttackerWay toMessage(const ReferencePath& way, const std::string& attacker_id);

/// Returns true for the empty attack that is published when the attack has ended.
inline bool isNone(const collision_forge::Attack& attack) {
  return attack.trajectory.attacker_id.empty();
}

/// Throws MessageError for an unknown agent class, a size that is not positive, points
/// or past states that are not finite, times that do not grow, and a past that does not fit
/// `added`.
AttackerTrajectory fromMessage(const collision_forge::AttackerTrajectory& message);
collision_forge::AttackerTrajectory toMessage(const AttackerTrajectory& trajectory);

collision_forge::CollisionReport toMessage(const CollisionReport& report,
                                           const std::string& attacker_id, double now);

/// Throws MessageError for a word that is no side of a box or no manoeuvre. `verified` and
/// `believable` of the message are ignored: they follow from the other fields.
CollisionReport fromMessage(const collision_forge::CollisionReport& message);

/// Returns an attack with status kOk, without alternatives. Throws like fromMessage() of pattern,
/// trajectory and report.
Realization fromMessage(const collision_forge::Attack& message);
/// `answer` must have status kOk; `now` is t0 of the snapshot, s.
collision_forge::Attack toMessage(const Realization& answer, const std::string& method, double now);

/// Marks `message` as adaptive and sets the attacker's phase, last decision and number of plans.
void setPlans(const std::vector<AttackerPlan>& plans, collision_forge::Attack& message);

}  // namespace forge
