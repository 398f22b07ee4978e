#pragma once

#include <exception>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/planner.h"

/// The line protocol between `forge test` and a planner's process (docs/planners.md): one JSON
/// object per line, UTF-8, without a byte order. Numbers are written so that they read back as the
/// same doubles. Metres, seconds, radians; global map frame; poses are the middle of a box.
namespace forge {

/// Version of the protocol. The first line of a process announces it: {"ready": 1}.
inline constexpr int kPlannerProtocol = 1;

/// Returns the request that begins a rollout, {"begin": ...} (keys: docs/planners.md). Contains the
/// task with the map within 200 m of the route. `interval`: s of scene time between two plans. The
/// functions of this file return and read lines without a line end.
std::string beginLine(const DrivingTask& task, double interval);
/// Returns the request for a plan, {"plan": ...} (keys: docs/planners.md), which contains the whole
/// observation.
std::string planLine(const Observation& observation);

/// Returns the points in a response (rows as in pointsLine()), acceleration and curvature 0 where
/// they are missing; empty if the response has no key "points". A response with the key "error"
/// throws its text as PlannerTimeout if its "failure" is "timed_out", as LatePlan if it is "late",
/// else as std::runtime_error. Throws JsonLineError for a line that is not a response. Does not
/// check times or numbers of the points.
std::vector<TrajectoryPoint> readPlanResponse(const std::string& line);

/// Throws JsonLineError if the first line of a process does not announce kPlannerProtocol,
/// std::runtime_error with its text if the line has the key "error".
void checkReadyLine(const std::string& line);

/// A request as a planner's process reads it: the inverse of beginLine() and planLine().
struct PlanRequest {
  bool is_begin = false;  ///< true: beginLine(), `task` and `interval` are set; false: planLine(),
                          ///< `observation` is set
  DrivingTask task;       ///< its map is the part in the line
  double interval = 0.0;  ///< s of scene time between two plans
  Observation observation;  ///< as given to planLine()
};
/// Returns the request in a line. Throws JsonLineError for a line that is not a request.
PlanRequest readPlanRequest(const std::string& line);

/// Returns the response to planLine(): {"points": ...}, one row per point: time, x, y, yaw, speed,
/// acceleration, curvature.
std::string pointsLine(const std::vector<TrajectoryPoint>& points);
/// Returns the response to beginLine(): {}.
std::string begunLine();
/// Returns the response for an exception of a planner: its message as "error", and as "failure"
/// "timed_out" for PlannerTimeout, "late" for LatePlan, no such key for other types.
std::string errorLine(const std::exception& error);
/// Returns the first line of a process, {"ready": VERSION}.
std::string readyLine();

}  // namespace forge
