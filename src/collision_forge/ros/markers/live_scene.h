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
  const collision_forge::Attack* attack = nullptr;            ///< null where none is under way
  const collision_forge::CollisionReport* verdict = nullptr;  ///< what became of it; null before
  std::optional<Pose2> ego = {};  ///< as /tf has it; empty: predicted from the scene
  /// What follows the contact; empty where `now` is before the contact.
  std::optional<PostCrashMotion> crash = {};
  std::vector<OrientedBox> words_obstacles = {};  ///< as of WordsPlace
};

/// Returns what the agents other than the attacker cover from now until the view leaves the
/// contact, if they keep their velocities: what the words of the attack are not to cover.
std::vector<OrientedBox> coveredByOthers(const LiveScene& live);

/// Everybody where they are between the frames, with their trails. Of an attack under way its
/// attacker as it drives ("attacker"), as recorded ("recorded"), and in words the countdown or the
/// verdict ("words"). From the contact on ego and attacker are where the crash has them, with a
/// mark where they touched ("contact"), and the ego as recorded drives on ("recorded").
visualization_msgs::MarkerArray liveMarkers(const LiveScene& live);

/// Returns the part of the map that the picture is to show. While an attack is under way it holds
/// the ego, the attacker and the predicted contact; for kCrashView after a contact both vehicles
/// up to where they stand; else the ego with its surroundings. Empty where no ego is in the scene.
std::optional<ShownArea> shownArea(const LiveScene& live);

}  // namespace forge
