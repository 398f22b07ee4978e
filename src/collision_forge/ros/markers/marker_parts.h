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

/// Shared parts of the pictures of attacks and planner tests. Positions are in the map frame, m. A
/// ghost is a pale copy of a vehicle's box at a time on its path. Functions add...() append to
/// `markers`, in the namespaces that their comments name.
namespace forge {

// Heights above ground, m; higher markers hide lower ones in a top view.
inline constexpr double kGhostHeight = 0.2;
inline constexpr double kContactBoxHeight = 0.25;  // of the vehicles at contact
inline constexpr double kPathHeight = 4.5;         // above every bus
inline constexpr double kOutlineHeight = 4.6;      // of the outlines of ghosts
inline constexpr double kContactHeight = 4.8;      // of the contact point
inline constexpr double kPlateHeight = 4.9;        // of the plates under texts
inline constexpr double kTextHeight = 5.0;
inline constexpr double kVehicleHeight = 1.5;  // m, height of a box with unknown height

inline constexpr double kWordsLetterHeight = 1.5;  // m, of texts, at letterScale() 1

inline constexpr double kPathWidth = 0.3;        // m, of the lines of paths
inline constexpr double kContactDiameter = 1.0;  // m, of the disc at the contact point
inline constexpr float kContactAlpha = 0.45F;    // of the vehicles at contact

/// Returns length (x) and width (y) of a size in a message, m.
BoxSize sizeOf(const geometry_msgs::Vector3& size);

/// Returns true if agents of this class (constant of Agent.msg) can attack in a request that names
/// no attacker: motor vehicles (isMotorVehicle()). Returns false for an unknown constant.
bool canAttackClass(std::uint8_t agent_class);

/// Returns true if `id` is the id of a support vehicle of the attack.
bool isSupport(const std::string& id, const collision_forge::Attack& attack);

/// Adds the short form of an agent's id (namespace "ids") beside `shown`, the agent's box in the
/// picture. The side is chosen beside `framed`, the box in the newest frame, so that it changes
/// only with a new frame. Adds no text if it would cover an element of `obstacles` at every place
/// of the first kNearRings rings; else appends the text's box to `obstacles`. `scale`:
/// letterScale().
void addId(const std::string& id, const OrientedBox& framed, const OrientedBox& shown, double scale,
           std::vector<OrientedBox>& obstacles, MarkerList& markers);

/// Adds a text on a pale plate (namespace NAME_plate), so that it is legible on any background.
/// `middle`: centre of the text; `letter_height`: m.
void addWords(const std::string& name_space, const std::string& words, const Vector2& middle,
              double letter_height, MarkerList& markers);

/// Place of the text of an attack: beside `box`, on the side where the text covers the fewest of
/// `obstacles` and of the boxes on both vehicles' paths to the contact.
struct WordsPlace {
  OrientedBox box;                     ///< usually the attacker at contact
  std::vector<OrientedBox> obstacles;  ///< may be empty
};

/// Returns the box around the text of an attack, for the size that most texts have, whatever the
/// present text is. `scale`, also of addAttackWords(): letterScale().
OrientedBox wordsBox(const collision_forge::Attack& attack, const WordsPlace& place, double scale);

/// Adds `words`, the countdown or verdict of an attack, at wordsBox() (namespaces "words" and
/// "words_plate"), and on the opposite side, above or below the box `attacker` (the attacker in the
/// picture), the short form of the attacker's id ("ids"). The sides depend only on `attack` and
/// `place`, so that texts do not jump. The id is omitted while it overlaps the text.
void addAttackWords(const collision_forge::Attack& attack, const WordsPlace& place,
                    const OrientedBox& attacker, const std::string& words, double scale,
                    MarkerList& markers);

/// Adds a vehicle's path along the points up to `end` (s, clock of the points; inclusive, infinity:
/// all) with a ghost of `size` at the first point and then at the first point after each further
/// 0.5 s, in the namespaces NAME_path, NAME_ghosts and NAME_ghost_outlines. Adds nothing without
/// points up to `end`.
void addPath(const std::string& name, const std::vector<TrajectoryPoint>& points, double end,
             const BoxSize& size, const colors::MarkerColor& color, MarkerList& markers);

/// Adds the boxes of both vehicles at contact ("contact_boxes"), below the boxes of moving
/// vehicles, and a disc ("contact") at touchPoint(), which is returned. `ego` gets the ego's
/// colour, `other` gets `other_color`.
Vector2 addContact(const OrientedBox& ego, const OrientedBox& other,
                   const colors::MarkerColor& other_color, MarkerList& markers);

}  // namespace forge
