#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/PredictedPatterns.h>
#include <collision_forge/SceneSnapshot.h>
#include <collision_forge/TrafficLightArray.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// Markers for RViz, with frame and stamp of the message's header. Each array starts with DELETEALL
/// and so replaces the one before on its topic. Non-finite parts are skipped. Colours:
/// ros/markers/marker_colors.h. A ghost is a pale copy of a vehicle's box at a time on its path.
namespace forge {

/// Returns the areas and features of the map (except driveways), and the centrelines of lanes and
/// connectors with arrow heads in their direction. Throws MessageError for an unknown kind of
/// feature.
visualization_msgs::MarkerArray mapMarkers(const collision_forge::LaneMap& map);

/// Returns a disc in the light's colour (lightColor()) at each stop point.
visualization_msgs::MarkerArray lightMarkers(const collision_forge::TrafficLightArray& lights);

/// Returns the outlines of ego and attacker at impact for the first five patterns; each next drawn
/// one is half as opaque. The outlines lie below the boxes of vehicles. The attacker's size comes
/// from `scene`; of the five, patterns of an attacker that is not in `scene` are skipped.
visualization_msgs::MarkerArray patternMarkers(const collision_forge::PredictedPatterns& predicted,
                                               const collision_forge::SceneSnapshot& scene);

/// Returns the planned attack: the attacker's path to the contact (without one, to the end) with a
/// ghost every 0.5 s, both boxes of the pattern, and both vehicles at the contact of the attack's
/// report, if there is one. For an added attacker also its past (namespace "added_past"). For an
/// adaptive attacker, the motion until `now` (scene clock; by default before every attack) is a
/// broad line ("driven"), and path and ghosts show its current plan from then on; `now` is not used
/// for other attackers.
visualization_msgs::MarkerArray attackMarkers(const collision_forge::Attack& attack,
                                              const ros::Time& now = ros::Time());

/// Returns the markers after the verdict: the attacker's path without ghosts, up to the contact of
/// `verdict` (topic tested_report), or to the end if there was none.
visualization_msgs::MarkerArray pastAttackMarkers(const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport& verdict);

/// One instant of a crash. The caller keeps the objects behind the pointers.
struct CrashView {
  std_msgs::Header header;                           ///< time of the picture, and frame
  std::optional<OrientedBox> ego;                    ///< box at that time; empty if unknown
  const collision_forge::Attack* attack = nullptr;   ///< null before t0
  const collision_forge::Agent* attacker = nullptr;  ///< at that time; null before t0, or unknown
  std::vector<OrientedBox> words_obstacles = {};     ///< as WordsPlace::obstacles
};

/// Returns the boxes of ego and attacker; if `view.attack` is not null, also the markers of
/// attackMarkers() at the header's stamp, and beside the contact of the attack's report (without
/// one beside the end of the trajectory) as text the countdown or, from the contact on, the result
/// of this report.
visualization_msgs::MarkerArray crashMarkers(const CrashView& view);

/// Returns a box for each agent (namespace "agents"), red for the attacker (`attacker_id`; empty:
/// none) and in the colour of support vehicles for the `supports` (ids), and the short id beside
/// each agent that can attack (canAttackClass()), where addId() finds a free place.
visualization_msgs::MarkerArray annotationMarkers(const collision_forge::AgentArray& agents,
                                                  const std::string& attacker_id = "",
                                                  const std::vector<std::string>& supports = {});

/// Returns an array that deletes all earlier markers of its topic.
visualization_msgs::MarkerArray noMarkers(const std_msgs::Header& header);

}  // namespace forge
