#pragma once

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/json/json_line.h"

/// Motions and lines as lists of whole numbers. Each but the first is what it adds to the one
/// before, which compresses well.
namespace forge {

/// The values in whole units, as differences.
std::vector<double> differences(const std::vector<double>& values, double unit);

/// "x" and "y" of the object that is open: centimetres.
void writePlaces(JsonLineWriter& writer, const std::vector<Vector2>& places);

/// An object: "t" in ms from `origin`, "x" and "y" in cm, "yaw" in mrad.
void writeStates(JsonLineWriter& writer, const char* key, const std::vector<AgentState>& states,
                 double origin);

/// The same with "v" in cm/s and "a" in cm/s2, both along the heading.
void writeTrajectory(JsonLineWriter& writer, const char* key,
                     const std::vector<TrajectoryPoint>& points, double origin);

}  // namespace forge
