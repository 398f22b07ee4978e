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
/// and so replaces the one before. Colours: ros/markers/marker_colors.h.
namespace forge {

/// Returns the areas and features of the map, and the centrelines of lanes and connectors with
/// arrow heads.
visualization_msgs::MarkerArray mapMarkers(const collision_forge::LaneMap& map);

/// Returns a disc in the light's colour at each stop point, grey for an unknown colour.
visualization_msgs::MarkerArray lightMarkers(const collision_forge::TrafficLightArray& lights);

/// Returns the outlines of ego and attacker at impact for the first patterns; later ones are
/// fainter. The outlines lie below the boxes of vehicles. The attacker's size comes from `scene`;
/// patterns of an attacker that is not in `scene` are skipped.
visualization_msgs::MarkerArray patternMarkers(const collision_forge::PredictedPatterns& predicted,
                                               const collision_forge::SceneSnapshot& scene);

/// Returns the planned attack: the attacker's path to the contact with a ghost every 0.5 s, both
/// boxes of the pattern, and both vehicles at contact. For an added attacker also its past
/// (namespace "added_past"). For an adaptive attacker, the motion until `now` is a broad line
/// ("driven"), and path and ghosts show its current plan.
visualization_msgs::MarkerArray attackMarkers(const collision_forge::Attack& attack,
                                              const ros::Time& now = ros::Time());

/// Returns the markers after the verdict: the attacker's path, up to the contact if there was one.
visualization_msgs::MarkerArray pastAttackMarkers(const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport& verdict);

/// One instant of a crash.
struct CrashView {
  std_msgs::Header header;
  std::optional<OrientedBox> ego;                    ///< empty if unknown
  const collision_forge::Attack* attack = nullptr;   ///< null before t0, like the next
  const collision_forge::Agent* attacker = nullptr;  ///< at that time
  std::vector<OrientedBox> words_obstacles = {};     ///< as in WordsPlace
};

/// Returns the boxes of ego and attacker, attackMarkers(), and as text the countdown or, from the
/// contact on, the result of the attack's report.
visualization_msgs::MarkerArray crashMarkers(const CrashView& view);

/// Returns a box for each agent, red for the attacker and in the colour of support vehicles for the
/// `supports` (ids), and the short id beside each agent that can attack.
visualization_msgs::MarkerArray annotationMarkers(const collision_forge::AgentArray& agents,
                                                  const std::string& attacker_id = "",
                                                  const std::vector<std::string>& supports = {});

/// Returns an array that deletes all earlier markers.
visualization_msgs::MarkerArray noMarkers(const std_msgs::Header& header);

}  // namespace forge
