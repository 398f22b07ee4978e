#pragma once

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

// Fields of scenario files that concern poses and motions, as docs/scenarios.md defines them:
// global map frame, m, rad, m/s; times in s from `now` (s, clock of the values), rounded to 1 us.
// The write functions add fields to the open object; the read functions throw JsonLineError, also
// for a number beyond the limits.

/// Properties of a line on which the reading of its fields depends.
struct LineContext {
  const InputLimits& limits;
  bool is_oldest = false;     ///< version 5, which lacks fields
  bool has_severity = false;  ///< from version 7 on
  double now = 0.0;           ///< s, the scene's clock
};

/// Writes the object `key` with x and y in m, yaw in rad.
void writePose(JsonLineWriter& writer, const char* key, const Pose2& pose);
/// Reads an object of writePose().
Pose2 readPose(JsonObject object, const LineContext& line);

/// Returns a time on the scene's clock, s.
double readTime(JsonObject& object, const char* key, const LineContext& line);

/// Returns a speed, m/s; negative: backwards.
double readSpeed(JsonObject& object, const char* key, const LineContext& line);

/// Reads the fields "length" and "width", m.
BoxSize readBox(JsonObject& object, const InputLimits& limits);

/// Writes the array "trajectory".
void writePoints(JsonLineWriter& writer, const std::vector<TrajectoryPoint>& points, double now);
/// Reads the array of writePoints(), which may be empty. Throws also for times that do not
/// increase.
std::vector<TrajectoryPoint> readPoints(JsonObject& object, const LineContext& line);

/// Writes id, class, origin, box, past and trajectory. The speed of a past state is the component
/// of its velocity along the heading, rounded to 1e-6 m/s.
void writeVehicle(JsonLineWriter& writer, const AttackerTrajectory& trajectory, double now);
/// Reads the fields of writeVehicle() and leaves all others of the object unread. Throws also for
/// an unknown class or origin, a past that contradicts the origin, times that do not increase, and
/// an empty trajectory.
AttackerTrajectory readVehicle(JsonObject& object, const LineContext& line);

}  // namespace forge
