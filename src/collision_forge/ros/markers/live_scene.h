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

inline constexpr double kCrashView = 5.0;  // s for which the view stays at a contact

/// Input of one picture.
struct LiveScene {
  const collision_forge::SceneSnapshot* scene = nullptr;      ///< the newest
  ros::Time now;                                              ///< time of the picture
  const collision_forge::Attack* attack = nullptr;            ///< null without a running attack
  const collision_forge::CollisionReport* verdict = nullptr;  ///< outcome; null while unknown
  std::optional<Pose2> ego = {};  ///< from /tf; empty: predicted from the scene
  /// Motion after the contact; empty before the contact.
  std::optional<PostCrashMotion> crash = {};
  std::vector<OrientedBox> words_obstacles = {};  ///< as in WordsPlace
};

/// Returns the areas that the other agents cover from now until the view leaves the contact, at
/// constant velocity. Texts of the attack should not cover them.
std::vector<OrientedBox> coveredByOthers(const LiveScene& live);

/// Returns ego and agents, interpolated between frames, with trails. During an attack also the
/// attacker as driven (namespace "attacker") and as recorded ("recorded"), its support vehicles
/// ("supports"), and the countdown or verdict ("words"). After the contact ego and attacker move by
/// `crash`, with a mark at the contact point ("contact"), and the recorded ego continues
/// ("recorded").
visualization_msgs::MarkerArray liveMarkers(const LiveScene& live);

/// Returns the part of the map to show. During an attack it contains the ego, the attacker and the
/// predicted contact; for kCrashView seconds after a contact both vehicles up to standstill; else
/// the ego with its surroundings. Returns nullopt if the scene has no ego.
std::optional<ShownArea> shownArea(const LiveScene& live);

}  // namespace forge
