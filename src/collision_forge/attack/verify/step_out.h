#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// How a pedestrian gets onto the carriageway: drivable area that is no walkway.
struct StepOut {
  /// s, clock of the points: first point of the last unbroken stretch on the carriageway up to the
  /// contact; the first point after the contact (or the contact) if the pedestrian is not on the
  /// carriageway there
  double time = 0.0;
  /// Share 0..1 of the points before `time` that are where people walk: on a walkway or crosswalk,
  /// or beside the road edge. 1 if there is no such point: the pedestrian is in the road at t0.
  double among_people = 1.0;
};

/// Returns true if people walk at `place` (m, map frame): on a walkway or crosswalk, or off the
/// drivable area and about 3 m or less from it. True if the map has no drivable area.
bool isWherePeopleWalk(const Vector2& place, const LaneIndex& lanes);

/// Evaluates the points (box centres, map frame) up to `contact` (s, same clock). `points` must not
/// be empty.
StepOut stepOutOf(const std::vector<TrajectoryPoint>& points, double contact,
                  const LaneIndex& lanes);

/// Returns the reason why a pedestrian's attack is implausible, worded to follow "the attacker";
/// empty if it is plausible: until it steps out, at least 98 % of its points are where people walk.
std::string implausibleWalk(const StepOut& step_out);

}  // namespace forge
