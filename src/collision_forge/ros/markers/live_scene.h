#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/SceneSnapshot.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/ros/markers/shown_area.h"

/// The moving picture of a scene and its attack: metres, radians, map frame.
namespace forge {

inline constexpr double kCrashView = 5.0;  // s that the view stays at a contact

/// What is shown at one instant.
struct LiveScene {
  const collision_forge::SceneSnapshot* scene = nullptr;      ///< the newest
  ros::Time now;                                              ///< of the picture
  const collision_forge::Attack* attack = nullptr;            ///< null if there is none
  const collision_forge::CollisionReport* verdict = nullptr;  ///< its outcome; null before that
  std::optional<Pose2> ego = {};  ///< from /tf; empty: predicted from the scene
  /// Motion after the contact; empty before the contact.
  std::optional<PostCrashMotion> crash = {};
  std::vector<OrientedBox> words_obstacles = {};  ///< as of WordsPlace
};

/// Returns the areas that other agents cover from now until the view leaves the contact, if they
/// keep their velocities: obstacles for the text of the attack.
std::vector<OrientedBox> coveredByOthers(const LiveScene& live);

/// Returns all agents at `live.now`, with trails. With an attack also the attacker on its
/// trajectory
/// ("attacker"), as recorded ("recorded"), and the countdown or
/// verdict as text ("words"). From the contact on ego and attacker move as in `crash`, with a
/// mark where they touched ("contact"), and the ego as recorded drives on ("recorded").
visualization_msgs::MarkerArray liveMarkers(const LiveScene& live);

/// Returns the part of the map that the picture is to show. While an attack is under way it holds
/// the ego, the attacker and the predicted contact; for kCrashView after a contact both vehicles
/// up to where they stand; else the ego with its surroundings. Empty where no ego is in the scene.
std::optional<ShownArea> shownArea(const LiveScene& live);

}  // namespace forge
