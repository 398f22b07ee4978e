#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Returns a writer of CommonRoad XML 2020a (TU Munich; XML_commonRoad_XSD.xsd of commonroad-io):
/// NAME.xml, a scenario with one planning problem, in the record's map frame, metres, radians and
/// times as numbers of CrashRecord::step.
///
/// - Lanelets: the lanes with a centreline; the bounds are half a lane width to either side. Lanes
///   for bicycles follow as type `bicycleLane`, 1.5 m wide and without links.
/// - Obstacles: the ego is dynamic obstacle 1, the attacker 2; the planning problem has id 3. An
///   agent that is out of sight for a time becomes one obstacle per stretch; a stretch of one step
///   is left out. Vehicles at rest throughout and objects are static obstacles at their first pose.
/// - States: poses are box centres, velocities are along the heading.
/// - Planning problem: starts at t0; its goal is the ego's last pose. With a free ego, the ego is
///   not an obstacle and the goal is the end time alone.
/// - Attributes: `source` holds type, TTA, manoeuvre, seed, t0, contact time and driving side;
///   `date` is the day of the recording.
///
/// Two deviations from the schema, which commonroad-io accepts: initial states after step 0, and no
/// lanelet if no lane is near. write() throws std::invalid_argument for a number that is not
/// finite.
std::unique_ptr<CrashWriter> makeCommonRoadWriter(const ExportPlan& plan);

}  // namespace forge
