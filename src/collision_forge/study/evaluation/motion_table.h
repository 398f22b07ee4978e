#pragma once

#include <string>
#include <vector>

#include "collision_forge/study/evaluation/attack_figures.h"
#include "collision_forge/study/evaluation/options.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Returns the text of motion.csv, which python/collision_forge_study/scorecard.py reads: how the
/// attackers of `rows` drive, for each of `methods` in turn, and then each recorded window, whose
/// driver is "recorded". A row has driver, scene, type, tta (s), attackColumns(), and the limits of
/// the vehicle's class (config/vehicle_limits.yaml, drivable): max_steering_rate (rad/s), max_jerk
/// (m/s3) and max_lateral_acceleration (m/s2). Recorded windows have no type, TTA and peaks.
std::string motionTable(const std::vector<ResultRow>& rows, const std::vector<std::string>& methods,
                        const std::vector<RecordedMotion>& recorded, const StudyOptions& options);

}  // namespace forge
