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

inline constexpr double kCrashView = 5.0;  // s after a contact for which the view stays at it

/// Input of one picture. The caller keeps what the pointers refer to. Times are on the scene's
/// clock.
struct LiveScene {
  const collision_forge::SceneSnapshot* scene = nullptr;      ///< the newest; must not be null
  ros::Time now;                                              ///< time of the picture
  const collision_forge::Attack* attack = nullptr;            ///< null without a running attack
  const collision_forge::CollisionReport* verdict = nullptr;  ///< outcome; null while unknown
  /// Recorded ego's box middle at `now`, from /tf; empty: extrapolated from the scene.
  std::optional<Pose2> ego = {};
  /// Motion of ego and attacker after the contact; empty before a contact. Needs `attack`.
  std::optional<PostCrashMotion> crash = {};
  std::vector<OrientedBox> words_obstacles = {};  ///< as WordsPlace::obstacles
};

/// Returns the areas (sweptBox()) that the other agents cover at constant velocity from `live.now`
/// until kCrashView after the contact, predicted or not. Texts of the attack should not cover them:
/// LiveScene::words_obstacles. `live.attack` must not be null unless `live.crash` is set.
std::vector<OrientedBox> coveredByOthers(const LiveScene& live);

/// Returns ego and agents, extrapolated from the newest frame (shownPose()), with trails; without
/// an attacker in the picture also ids (namespace "ids"). During an attack also the attacker as
/// driven (namespace "attacker") and as recorded ("recorded"), and the countdown or verdict
/// ("words"). After the contact ego and attacker move by `crash`, with a mark at the contact point
/// ("contact"), and the recorded ego continues ("recorded").
visualization_msgs::MarkerArray liveMarkers(const LiveScene& live);

/// Returns the part of the map to show. During an attack it contains the ego, the attacker and the
/// predicted contact; for kCrashView seconds after a contact both vehicles up to standstill; else
/// the ego with its surroundings. Returns nullopt if the ego has no state in the newest frame.
std::optional<ShownArea> shownArea(const LiveScene& live);

}  // namespace forge
