#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/geometry/oriented_box.h"

/// Where texts stand in RViz that looks along -z with y up: beside boxes and never on one. Metres.
namespace forge {

/// What a text of such letters covers, about: x across, y up.
BoxSize textSize(const std::string& text, double letter_height);

/// The middle of a text beside `box`, as near as can be, so that it covers none of the obstacles,
/// of which the box is one; empty where it covers one wherever it is put.
std::optional<Vector2> placeBeside(const OrientedBox& box, const BoxSize& text,
                                   const std::vector<OrientedBox>& obstacles);

}  // namespace forge
