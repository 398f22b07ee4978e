#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/SceneSnapshot.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>

#include "collision_forge/geometry/pose2.h"
#include "collision_forge/verify/post_crash_motion.h"

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
};

/// Everybody where they are between the frames, with their trails. Of an attack under way its
/// attacker as it drives ("attacker"), as recorded ("recorded"), and in words the countdown or the
/// verdict ("words"). From the contact on ego and attacker are where the crash has them, with a
/// mark where they touched ("contact"), and the ego as recorded drives on ("recorded").
visualization_msgs::MarkerArray liveMarkers(const LiveScene& live);

/// Where a view that follows the ego looks: its pose as shown; for kCrashView after a contact that
/// of the crashed ego. Empty where no ego is in the scene.
std::optional<Pose2> viewedEgo(const LiveScene& live);

}  // namespace forge
