#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AgentTrack.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackerTrajectory.h>
#include <collision_forge/AttackerWay.h>
#include <collision_forge/CollisionPattern.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/EgoVehicle.h>
#include <collision_forge/EncodedScene.h>
#include <collision_forge/Future.h>
#include <collision_forge/GenerateCollision.h>
#include <collision_forge/LaneMap.h>
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

/// Between the core's types and the messages. Poses are planar: z, roll and pitch are dropped.
namespace forge {

/// A message that says something impossible; names the field and the value.
struct MessageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws MessageError where a message of that topic is in another frame than `map`; one without a
/// frame is taken to be in it.
void requireMapFrame(const std_msgs::Header& header, const char* topic);

/// The stamp of a time in seconds, whose toSec() is that time again. A double does not tell the
/// nanoseconds of today's times: of the stamps with the same toSec() that of a whole microsecond is
/// taken, which gives the stamps of nuScenes back as they were.
ros::Time stampOf(double time);

Pose2 fromMessage(const geometry_msgs::Pose& message);
Pose2 fromMessage(const geometry_msgs::Pose2D& message);
Pose2 fromMessage(const geometry_msgs::Transform& message);
geometry_msgs::Pose toPoseMessage(const Pose2& pose);
/// Moves and turns a pose there; height, roll and pitch stay.
void setPlanar(const Pose2& planar, geometry_msgs::Pose& pose);
geometry_msgs::Pose2D toPose2dMessage(const Pose2& pose);

geometry_msgs::Vector3 toMessage(const BoxSize& size);
/// Returns the size of the ego's box (m); nullopt unless both numbers are finite and above 0.
std::optional<BoxSize> egoSizeOf(const collision_forge::EgoVehicle& message);
TrajectoryPoint fromMessage(const collision_forge::TrajectoryPoint& message);
collision_forge::TrajectoryPoint toMessage(const TrajectoryPoint& point);

LaneMap fromMessage(const collision_forge::LaneMap& message);
collision_forge::LaneMap toMessage(const LaneMap& map, const ros::Time& stamp);

/// One track with one state an agent. Throws MessageError for an agent class that does not exist.
std::vector<Track> fromMessage(const collision_forge::AgentArray& message);

AgentState fromMessage(const collision_forge::TrackState& message);
collision_forge::TrackState toMessage(const AgentState& state);

Track fromMessage(const collision_forge::AgentTrack& message);
collision_forge::AgentTrack toMessage(const Track& track);

Future fromMessage(const collision_forge::Future& message);
collision_forge::Future toMessage(const Future& future);

/// The snapshot in an encoded scene, without a map.
Snapshot fromMessage(const collision_forge::SceneSnapshot& message);
collision_forge::SceneSnapshot toMessage(const Snapshot& snapshot);
collision_forge::EncodedScene toMessage(const Snapshot& snapshot, const SceneEncoding& encoding);

/// The request, or why there is none: UNKNOWN_TYPE or INVALID_INPUT. An empty mode is history. What
/// counts as the crash is `crash`, unless the message says otherwise; an adaptive attacker sets out
/// however little its first plan promises.
std::variant<CollisionRequest, Status> fromMessage(const collision_forge::CollisionRequest& message,
                                                   const CrashDefinition& crash);
/// With every word that it has by default.
collision_forge::CollisionRequest toMessage(const CollisionRequest& request);
/// What generate_collision is asked, but for the method. Mode history of an adaptive attacker is
/// mode adaptive.
collision_forge::CollisionRequest requestIn(
    const collision_forge::GenerateCollision::Request& message);

CollisionPattern fromMessage(const collision_forge::CollisionPattern& message);
collision_forge::CollisionPattern toMessage(const CollisionPattern& pattern, double now);

/// Throws MessageError for a way that is none.
ReferencePath fromMessage(const collision_forge::AttackerWay& message);
collision_forge::AttackerWay toMessage(const ReferencePath& way, const std::string& attacker_id);

/// What is published in place of an attack that is over and done with.
inline bool isNone(const collision_forge::Attack& attack) {
  return attack.trajectory.attacker_id.empty();
}

/// Throws MessageError for an agent class that does not exist, a size that is not positive, points
/// or past states that are not finite, times that do not grow, and a past that does not fit
/// `added`.
AttackerTrajectory fromMessage(const collision_forge::AttackerTrajectory& message);
collision_forge::AttackerTrajectory toMessage(const AttackerTrajectory& trajectory);

collision_forge::CollisionReport toMessage(const CollisionReport& report,
                                           const std::string& attacker_id, double now);

/// Throws MessageError for a word that is no side of a box or no manoeuvre. `verified` and
/// `believable` of the message are ignored: they follow from the other fields.
CollisionReport fromMessage(const collision_forge::CollisionReport& message);

/// An answer with kOk and without alternatives. Throws as fromMessage() of pattern, trajectory and
/// report.
Realization fromMessage(const collision_forge::Attack& message);
/// An answer with kOk. `now`: of the snapshot.
collision_forge::Attack toMessage(const Realization& answer, const std::string& method, double now);

/// Says in an attack that its attacker sees and reacts, and what it decided last.
void setPlans(const std::vector<AttackerPlan>& plans, collision_forge::Attack& message);

}  // namespace forge
