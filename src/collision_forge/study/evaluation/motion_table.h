#pragma once

#include <string>
#include <vector>

#include "collision_forge/study/evaluation/attack_figures.h"
#include "collision_forge/study/evaluation/options.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Returns the text of motion.csv, the input of python/collision_forge_study/scorecard.py: one row
/// for each attack in `rows`, grouped by `methods`, then one for each recorded window, with the
/// driver "recorded". Columns: driver, scene, type, tta (s), attackColumns(), and the drivable
/// limits of the vehicle's class: max_steering_rate (rad/s), max_jerk (m/s3),
/// max_lateral_acceleration (m/s2). Type and TTA of recorded windows are empty, their peaks are 0.
std::string motionTable(const std::vector<ResultRow>& rows, const std::vector<std::string>& methods,
                        const std::vector<RecordedMotion>& recorded, const StudyOptions& options);

}  // namespace forge
