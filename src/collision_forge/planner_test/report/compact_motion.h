#pragma once

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/json/json_line.h"

/// Motions and lines as lists of integers. Each element but the first is the difference to the
/// previous one, which compresses well.
namespace forge {

/// Returns the values as multiples of `unit`, rounded: the first one, then the difference of each
/// to the one before.
std::vector<double> differences(const std::vector<double>& values, double unit);

/// Writes "x" and "y" into the open object: cm.
void writePlaces(JsonLineWriter& writer, const std::vector<Vector2>& places);

/// Writes an object: "t" in ms from `origin` (s), "x" and "y" in cm, "yaw" in mrad.
void writeStates(JsonLineWriter& writer, const char* key, const std::vector<AgentState>& states,
                 double origin);

/// As writeStates(), with "v" in cm/s and "a" in cm/s2, both along the heading.
void writeTrajectory(JsonLineWriter& writer, const char* key,
                     const std::vector<TrajectoryPoint>& points, double origin);

}  // namespace forge
