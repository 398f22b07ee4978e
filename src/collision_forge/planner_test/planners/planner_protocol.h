#pragma once

#include <exception>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/planner.h"

/// The line protocol between `forge test` and a planner's process (docs/planners.md): one JSON
/// object per line, UTF-8, without a byte order. Numbers are written so that they read back as the
/// same doubles. Metres, seconds, radians; global map frame; poses are the middle of a box.
namespace forge {

/// The first line of a process: {"ready": 1}, with the version of the protocol.
inline constexpr int kPlannerProtocol = 1;

/// Returns the request that begins a rollout. Contains the map within 200 m of the route. The
/// functions of this file return and read lines without a line end.
std::string beginLine(const DrivingTask& task, double interval);
/// Returns the request for a plan.
std::string planLine(const Observation& observation);

/// Returns the points in a response; none if it has no key "points". A response with the key
/// "error" throws its text as PlannerTimeout if its "failure" is "timed_out", as LatePlan if it is
/// "late", else as std::runtime_error. Throws JsonLineError for a line that is not a response.
std::vector<TrajectoryPoint> readPlanResponse(const std::string& line);

/// Throws JsonLineError if the first line of a process does not announce kPlannerProtocol.
void checkReadyLine(const std::string& line);

/// A request as a planner's process reads it: the inverse of beginLine() and planLine().
struct PlanRequest {
  bool is_begin = false;    ///< beginLine(); else planLine()
  DrivingTask task;         ///< with is_begin; its map is the part in the line
  double interval = 0.0;    ///< s, with is_begin
  Observation observation;  ///< else
};
/// Returns the request in a line. Throws JsonLineError.
PlanRequest readPlanRequest(const std::string& line);

/// Returns the response to planLine().
std::string pointsLine(const std::vector<TrajectoryPoint>& points);
/// Returns the response to beginLine().
std::string begunLine();
/// Returns the response for an exception of a planner, with the "failure" of its type.
std::string errorLine(const std::exception& error);
/// Returns the first line of a process.
std::string readyLine();

}  // namespace forge
