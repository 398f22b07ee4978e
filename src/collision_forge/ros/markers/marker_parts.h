#pragma once

#include <collision_forge/Attack.h>
#include <geometry_msgs/Vector3.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/ros/markers/marker_list.h"

/// Marker parts shared by the pictures of attacks and planner tests.
namespace forge {

// Heights above ground, m: what should be seen from above lies higher.
inline constexpr double kGhostHeight = 0.2;
inline constexpr double kContactBoxHeight = 0.25;
inline constexpr double kPathHeight = 4.5;  // above every bus
inline constexpr double kOutlineHeight = 4.6;
inline constexpr double kContactHeight = 4.8;
inline constexpr double kPlateHeight = 4.9;
inline constexpr double kTextHeight = 5.0;
inline constexpr double kVehicleHeight = 1.5;  // of a box whose height is unknown

inline constexpr double kWordsLetterHeight = 1.5;  // m, of outcomes in words, at letterScale() 1

inline constexpr double kPathWidth = 0.3;        // m, of lines
inline constexpr double kContactDiameter = 1.0;  // m
inline constexpr float kContactAlpha = 0.45F;    // of the vehicles at contact

BoxSize sizeOf(const geometry_msgs::Vector3& size);

/// Agent constants.
bool canAttackClass(std::uint8_t agent_class);

/// Adds the short form of an agent's id ("ids") beside `shown`, the agent's box in the picture. The
/// side is the one where the text covers none of the obstacles beside `framed`, the agent's box in
/// the newest frame, so that the text changes its side at a frame only. No text is added where
/// every side covers an obstacle. The text's own box joins the obstacles. `scale` is that of
/// letterScale().
void addId(const std::string& id, const OrientedBox& framed, const OrientedBox& shown, double scale,
           std::vector<OrientedBox>& obstacles, MarkerList& markers);

/// Adds words on a pale plate, which keeps them legible over everything.
void addWords(const std::string& name_space, const std::string& words, const Vector2& middle,
              double letter_height, MarkerList& markers);

/// Position of the text of an attack: beside `box`, on the side that covers least of the paths of
/// both vehicles to the contact and of `obstacles`.
struct WordsPlace {
  OrientedBox box;
  std::vector<OrientedBox> obstacles;
};

/// Returns the box that the text of an attack fills.
OrientedBox wordsBox(const collision_forge::Attack& attack, const WordsPlace& place, double scale);

/// Adds the words of an attack, its countdown or its verdict ("words"), and above or below
/// `attacker`, on the other side, the short form of its id ("ids"). The sides depend on the attack
/// and the place alone: the texts keep their places while the vehicles move. The id is left out
/// while it would lie on the words.
void addAttackWords(const collision_forge::Attack& attack, const WordsPlace& place,
                    const OrientedBox& attacker, const std::string& words, double scale,
                    MarkerList& markers);

/// Adds a vehicle's path up to `end` (s, the points' clock) with a ghost of it every half second,
/// in the namespaces NAME_path, NAME_ghosts and NAME_ghost_outlines.
void addWay(const std::string& name, const std::vector<TrajectoryPoint>& points, double end,
            const BoxSize& size, const colors::MarkerColor& color, MarkerList& markers);

/// Adds both vehicles at contact, on the road under the boxes of vehicles, and a disc at the
/// contact point, which is returned.
Vector2 addContact(const OrientedBox& ego, const OrientedBox& other,
                   const colors::MarkerColor& other_color, MarkerList& markers);

}  // namespace forge
