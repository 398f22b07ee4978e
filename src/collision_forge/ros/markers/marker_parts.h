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

/// Shared parts of the pictures of attacks and planner tests.
namespace forge {

// Heights above ground, m; higher markers hide lower ones in a top view.
inline constexpr double kGhostHeight = 0.2;
inline constexpr double kContactBoxHeight = 0.25;
inline constexpr double kPathHeight = 4.5;  // above every bus
inline constexpr double kOutlineHeight = 4.6;
inline constexpr double kContactHeight = 4.8;
inline constexpr double kPlateHeight = 4.9;
inline constexpr double kTextHeight = 5.0;
inline constexpr double kVehicleHeight = 1.5;  // of a box with unknown height

inline constexpr double kWordsLetterHeight = 1.5;  // m, of texts, at letterScale() 1

inline constexpr double kPathWidth = 0.3;        // m, of lines
inline constexpr double kContactDiameter = 1.0;  // m
inline constexpr float kContactAlpha = 0.45F;    // of the vehicles at contact

/// Returns length (x) and width (y) of a size in a message, m.
BoxSize sizeOf(const geometry_msgs::Vector3& size);

/// Returns true if agents of this class (Agent constants) can attack unnamed: motor vehicles.
bool canAttackClass(std::uint8_t agent_class);

/// Returns true if `id` is the id of a support vehicle of the attack.
bool isSupport(const std::string& id, const collision_forge::Attack& attack);

/// Adds the short form of an agent's id (namespace "ids") beside `shown`, the agent's box in the
/// picture. The side is chosen beside `framed`, the box in the newest frame, so that it changes
/// only with a new frame. Adds no text if it would cover an obstacle on every side; else appends
/// the text's box to `obstacles`. `scale`: letterScale().
void addId(const std::string& id, const OrientedBox& framed, const OrientedBox& shown, double scale,
           std::vector<OrientedBox>& obstacles, MarkerList& markers);

/// Adds a text on a pale plate, so that it is legible on any background.
void addWords(const std::string& name_space, const std::string& words, const Vector2& middle,
              double letter_height, MarkerList& markers);

/// Place of the text of an attack: beside `box`, on the side that covers the least of `obstacles`
/// and of both vehicles' paths to the contact.
struct WordsPlace {
  OrientedBox box;
  std::vector<OrientedBox> obstacles;
};

/// Returns the box around the text of an attack.
OrientedBox wordsBox(const collision_forge::Attack& attack, const WordsPlace& place, double scale);

/// Adds the text of an attack, its countdown or verdict (namespace "words"), and on the opposite
/// side, above or below the box `attacker`, the short form of its id ("ids"). The sides depend only
/// on `attack` and `place`, so that texts do not jump. The id is omitted while it overlaps the
/// text.
void addAttackWords(const collision_forge::Attack& attack, const WordsPlace& place,
                    const OrientedBox& attacker, const std::string& words, double scale,
                    MarkerList& markers);

/// Adds a vehicle's path up to `end` (s, clock of the points) with a ghost every 0.5 s, in the
/// namespaces NAME_path, NAME_ghosts and NAME_ghost_outlines.
void addWay(const std::string& name, const std::vector<TrajectoryPoint>& points, double end,
            const BoxSize& size, const colors::MarkerColor& color, MarkerList& markers);

/// Adds both vehicles at contact, below the boxes of moving vehicles, and a disc at the contact
/// point. Returns the contact point.
Vector2 addContact(const OrientedBox& ego, const OrientedBox& other,
                   const colors::MarkerColor& other_color, MarkerList& markers);

}  // namespace forge
