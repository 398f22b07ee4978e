#pragma once

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/json/json_line.h"

/// Motions and lines as lists of integers, each list made by differences(), which compresses well.
/// Positions and yaw angles are in the frame of the arguments.
namespace forge {

/// Returns the values as multiples of `unit`, rounded to integers: the first one, then the
/// difference of each rounded multiple to the one before, so that rounding errors do not add up.
/// Empty for no values.
std::vector<double> differences(const std::vector<double>& values, double unit);

/// Writes the lists "x" and "y" into the open object, as differences() in cm, one element per
/// place. `places`: m.
void writePlaces(JsonLineWriter& writer, const std::vector<Vector2>& places);

/// Writes an object named `key` into the open object, with the lists "t" (ms from `origin`), "x"
/// and "y" (cm) and "yaw" (mrad), each as differences(), one element per state. `origin`: s, on the
/// clock of the states.
void writeStates(JsonLineWriter& writer, const char* key, const std::vector<AgentState>& states,
                 double origin);

/// As writeStates(), plus the lists "v" (cm/s) and "a" (cm/s2), both along the heading.
void writeTrajectory(JsonLineWriter& writer, const char* key,
                     const std::vector<TrajectoryPoint>& points, double origin);

}  // namespace forge
