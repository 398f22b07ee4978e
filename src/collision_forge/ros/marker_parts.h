#pragma once

#include <geometry_msgs/Vector3.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/geometry/oriented_box.h"
#include "collision_forge/ros/marker_list.h"
#include "collision_forge/scene/attack.h"

/// What pictures of an attack and of a planner's test share.
namespace forge {

// Heights above ground, m: what should be seen from above lies higher.
inline constexpr double kGhostHeight = 0.2;
inline constexpr double kPathHeight = 4.5;  // above every bus
inline constexpr double kOutlineHeight = 4.6;
inline constexpr double kContactHeight = 4.8;
inline constexpr double kTextHeight = 5.0;
inline constexpr double kVehicleHeight = 1.5;  // of a box whose height is unknown

inline constexpr double kPathWidth = 0.3;        // m, of lines
inline constexpr double kContactDiameter = 1.0;  // m
inline constexpr float kContactAlpha = 0.45F;    // of the vehicles at contact

/// printf() of one number.
std::string formatted(const char* pattern, double value);

BoxSize sizeOf(const geometry_msgs::Vector3& size);

/// Agent constants.
bool canAttackClass(std::uint8_t agent_class);

/// The start of an id beside its box and on none of the others; nothing where that cannot be. Long
/// ids (nuScenes: 32 letters) would hide the scene.
void addId(const std::string& id, const OrientedBox& box, const std::vector<OrientedBox>& boxes,
           MarkerList& markers);

/// How a crash comes and goes ("words"), beside a box and on none of the others, if that can be.
/// The words' own box joins the others.
void addWordsBeside(const OrientedBox& box, const std::string& words,
                    std::vector<OrientedBox>& boxes, MarkerList& markers);

/// A vehicle's way up to `end` (s, the points' clock) with a ghost of it every half second, in the
/// namespaces NAME_path, NAME_ghosts and NAME_ghost_outlines.
void addWay(const std::string& name, const std::vector<TrajectoryPoint>& points, double end,
            const BoxSize& size, const colors::MarkerColor& color, MarkerList& markers);

/// Both vehicles at contact, and a disc where they touch; returns where.
Vector2 addContact(const OrientedBox& ego, const OrientedBox& other,
                   const colors::MarkerColor& other_color, MarkerList& markers);

/// A text as far off the place into that direction as to leave the place free.
void addReport(const std::string& text, const Vector2& place, const Vector2& direction,
               MarkerList& markers);

}  // namespace forge
