#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// CommonRoad XML 2020a (TU Munich; XML_commonRoad_XSD.xsd of commonroad-io): NAME.xml, a scenario
/// with one planning problem. The record's map frame in metres, radians and steps of the record.
///
/// Lanelets are the lanes that have a centreline; their bounds are half a width off it on either
/// side. The ego is dynamic obstacle 1, the attacker 2 and the planning problem 3. Whoever is out
/// of sight for a time is an obstacle a stretch, and at a single step left out. A vehicle that
/// stands all the time is a static obstacle, as are things, which stay where they are first seen.
/// Poses are the middles of boxes, velocities are along the heading.
///
/// The planning problem begins at now; its goal is the ego's last place at the end of the record.
/// A free ego is no obstacle, and its goal is the end alone. The attribute `source` tells type,
/// TTA, manoeuvre, seed, now and contact; `date` is the day of the recording.
///
/// Two things the schema does not allow, but commonroad-io reads: an initial state that is not at
/// step 0, of those who are seen later and of a problem that begins later; and no lanelet, where no
/// lane is near.
std::unique_ptr<CrashWriter> makeCommonRoadWriter(const ExportPlan& plan);

}  // namespace forge
