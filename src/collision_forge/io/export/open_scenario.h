#pragma once

#include <memory>

#include "collision_forge/io/export/crash_writer.h"

namespace forge {

/// OpenSCENARIO XML 1.2 (ASAM, 2022) with its roads in OpenDRIVE 1.6: NAME.xosc and NAME.xodr.
///
/// Ego, attacker and others follow polylines of timed places, `position` mode and absolute times;
/// a car's origin is the middle of its rear axle, everybody else's the middle of the box. Who comes
/// later or goes earlier is added and deleted. Type, TTA, manoeuvre and seed are parameters. The
/// storyboard stops at the end of the record.
std::unique_ptr<CrashWriter> makeOpenScenarioWriter(const ExportPlan& plan);

}  // namespace forge
