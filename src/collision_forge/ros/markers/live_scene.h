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
  const collision_forge::CollisionReport* verdict = nullptr;  ///< verdictBy(); null while unknown
  /// Recorded ego's box middle at `now`, from /tf; empty: extrapolated from the scene.
  std::optional<Pose2> ego = {};
  /// Motion of ego and attacker after the contact; empty before a contact. Needs `attack`.
  std::optional<PostCrashMotion> crash = {};
  std::vector<OrientedBox> words_obstacles = {};  ///< as WordsPlace::obstacles
};

/// Returns the areas (sweptBox()) that the other agents of the newest frame cover at constant
/// velocity from `live.now` until kCrashView after the contact that the attack's report predicts;
/// until kCrashView after `live.now` if that contact is past, no contact is predicted, or
/// `live.crash` is set. Texts of the attack should not cover these areas:
/// LiveScene::words_obstacles. `live.attack` must not be null unless `live.crash` is set.
std::vector<OrientedBox> coveredByOthers(const LiveScene& live);

/// Returns ego ("ego") and agents ("agents") that have a state in the newest frame, extrapolated
/// from it (shownPose()), with trails ("trails"); names in parentheses are namespaces. Without an
/// attacker in the picture also the ids ("ids") of the agents within 40 m of the ego that can
/// attack (canAttackClass()). With `attack` also its support vehicles ("supports") until their last
/// point, and longer if they stand there; they replace agents of their ids. From the attack's t0 on
/// also the attacker as driven ("attacker") and as recorded ("recorded"), and the countdown or
/// verdict ("words"). After the contact ego and attacker move by `crash`, with a mark at the
/// contact point ("contact"), and the recorded ego continues ("recorded").
visualization_msgs::MarkerArray liveMarkers(const LiveScene& live);

/// Returns the part of the map to show. From t0 of an attack until its verdict it contains the ego,
/// the attacker, the predicted contact if there is one, and the text; for kCrashView seconds after
/// a contact both vehicles up to standstill, and the text; else the ego with its surroundings
/// (kUsualWidth). Returns nullopt if the ego has no state in the newest frame, except for
/// kCrashView seconds after a contact.
std::optional<ShownArea> shownArea(const LiveScene& live);

}  // namespace forge
