#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>
#include <collision_forge/LaneMap.h>
#include <collision_forge/PredictedPatterns.h>
#include <collision_forge/SceneSnapshot.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>

#include "collision_forge/base/geometry/oriented_box.h"

/// Markers of messages for RViz. Frame and stamp are those of the message's header; every array
/// starts with DELETEALL and so replaces the one before. Colours: ros/markers/marker_colors.h.
namespace forge {

/// Drivable area, and the centrelines of lanes and connectors with arrow heads along them.
visualization_msgs::MarkerArray mapMarkers(const collision_forge::LaneMap& map);

/// The first patterns as pairs of outlines, the ego's and the attacker's box at impact, the fainter
/// the less promising. The outlines lie on the road, under the boxes of vehicles. Attackers have
/// their size in `scene`; patterns of an attacker that is not there are left out.
visualization_msgs::MarkerArray patternMarkers(const collision_forge::PredictedPatterns& predicted,
                                               const collision_forge::SceneSnapshot& scene);

/// Returns the markers of an attack: the attacker's path to the contact with a ghost every half
/// second, the pattern's two boxes, and both vehicles at the contact. For an added attacker also
/// its past ("added_past"). For an adaptive attacker a broad line shows the driven part until `now`
/// ("driven"); path and ghosts show its current plan.
visualization_msgs::MarkerArray attackMarkers(const collision_forge::Attack& attack,
                                              const ros::Time& now = ros::Time());

/// Returns the markers that stay after the verdict: the attacker's path, to the contact if there
/// was one.
visualization_msgs::MarkerArray pastAttackMarkers(const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport& verdict);

/// One instant of a crash.
struct CrashView {
  std_msgs::Header header;
  std::optional<OrientedBox> ego;                    ///< empty if unknown
  const collision_forge::Attack* attack = nullptr;   ///< null before it was made, like `attacker`
  const collision_forge::Agent* attacker = nullptr;  ///< its state at this instant
  std::vector<OrientedBox> words_obstacles = {};     ///< as of WordsPlace
};

/// The boxes of ego and attacker as they stand, attackMarkers(), and a text: the countdown or,
/// from the contact on, the outcome in the attack's report.
visualization_msgs::MarkerArray crashMarkers(const CrashView& view);

/// Returns a box for each agent, the attacker's in red, with the start of the id beside agents of
/// classes that can attack.
visualization_msgs::MarkerArray annotationMarkers(const collision_forge::AgentArray& agents,
                                                  const std::string& attacker_id = "");

/// Returns an array that deletes all markers.
visualization_msgs::MarkerArray noMarkers(const std_msgs::Header& header);

}  // namespace forge
