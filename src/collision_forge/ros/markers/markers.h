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

/// Messages as RViz shows them. Frame and stamp are those of the message's header; every array
/// starts with DELETEALL and so replaces the one before. Colours: ros/markers/marker_colors.h.
namespace forge {

/// Drivable area, and the centrelines of lanes and connectors with arrow heads along them.
visualization_msgs::MarkerArray mapMarkers(const collision_forge::LaneMap& map);

/// The first patterns as pairs of outlines, the ego's and the attacker's box at impact, the fainter
/// the less promising. The outlines lie on the road, under the boxes of vehicles. Attackers have
/// their size in `scene`; patterns of an attacker that is not there are left out.
visualization_msgs::MarkerArray patternMarkers(const collision_forge::PredictedPatterns& predicted,
                                               const collision_forge::SceneSnapshot& scene);

/// What an attack is to be: the attacker's way to the contact with a ghost every half second, the
/// pattern's two boxes, and both vehicles at the contact. Of an attacker that was added also its
/// past ("added_past"). Of an attacker that sees and reacts what it drove until `now` is a broad
/// line ("driven"), and the way and the ghosts are those of its plan.
visualization_msgs::MarkerArray attackMarkers(const collision_forge::Attack& attack,
                                              const ros::Time& now = ros::Time());

/// What is left of it once there is a verdict: the attacker's way, to the contact if there was one.
visualization_msgs::MarkerArray pastAttackMarkers(const collision_forge::Attack& attack,
                                                  const collision_forge::CollisionReport& verdict);

/// One instant of a crash.
struct CrashView {
  std_msgs::Header header;
  std::optional<OrientedBox> ego;                    ///< empty where nobody knows
  const collision_forge::Attack* attack = nullptr;   ///< null before it was made, as the next
  const collision_forge::Agent* attacker = nullptr;  ///< as it stands then
  std::vector<OrientedBox> words_obstacles = {};     ///< as of WordsPlace
};

/// The boxes of ego and attacker as they stand, attackMarkers(), and in words the countdown or,
/// from the contact on, what the attack's report says.
visualization_msgs::MarkerArray crashMarkers(const CrashView& view);

/// A box for everybody, the attacker's, if there is one, red, and beside it the start of the id of
/// what can attack.
visualization_msgs::MarkerArray annotationMarkers(const collision_forge::AgentArray& agents,
                                                  const std::string& attacker_id = "");

/// Takes away what was shown.
visualization_msgs::MarkerArray noMarkers(const std_msgs::Header& header);

}  // namespace forge
