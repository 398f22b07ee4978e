#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// Returns a writer of OpenSCENARIO XML 1.2 (ASAM, 2022) with roads in OpenDRIVE 1.6: NAME.xosc and
/// NAME.xodr.
///
/// All entities follow timed polylines (following mode `position`, absolute times). The origin of a
/// vehicle is the centre of its rear axle, of another entity the box centre. Entities are named
/// ego, attacker and other_N (N: place in CrashRecord::other_agents, from 1); a track that was out
/// of sight for a time gets further entities with the suffixes _2, _3, ..., and stretches of one
/// step are left out. Entities that appear later or disappear earlier are added and deleted. Type,
/// TTA, manoeuvre and seed are parameters. The storyboard stops at the end of the record. With a
/// free ego, only the ego's start is set, and the attacker starts when the ego is as close to the
/// place of the contact, in time, as at the start of the record. With ExportPlan::for_carla, the
/// origin of every entity is its box centre and all entities exist throughout. finish() reports the
/// number of unbundled lanes (LaneBundles::unbundled) on stderr. write() throws
/// std::invalid_argument for a number that is not finite.
std::unique_ptr<CrashWriter> makeOpenScenarioWriter(const ExportPlan& plan);

}  // namespace forge
