#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/base/config/section.h"
#include "collision_forge/planner_test/trials/options.h"

namespace forge {

/// Numbers of planners.yaml by their keys' paths in the file, as "pdm.idm.min_gap".
using PlannerValues = std::map<std::string, double>;

/// The values to be tried of some of these keys, each at least one, all different.
using PlannerGrid = std::map<std::string, std::vector<double>>;

/// Section `planner` of a file like config/tuning.yaml. Throws ConfigError for a missing section,
/// one without keys, and a value that is no list of different numbers.
PlannerGrid readPlannerGrid(Section file, const std::string& planner);
PlannerGrid readPlannerGrid(const std::string& path, const std::string& planner);

/// The numbers that planners.yaml, whose text is `text`, has for the keys of the grid. Throws
/// ConfigError, naming `path`, for a key that the file does not have or that is no number.
PlannerValues readPlannerValues(const std::string& path, const std::string& text,
                                const PlannerGrid& grid);

/// `text` with these numbers; those that it has already, comments and all else stay as written.
/// Throws as readPlannerValues().
std::string withPlannerValues(const std::string& path, const std::string& text,
                              const PlannerValues& values);

/// The options of planners.yaml with these numbers for the planner under test: the traffic that
/// reacts keeps those of `text`. `limits` are those of the ego. Throws ConfigError, naming `path`,
/// for a key or value that the file cannot have.
TrialOptions readTrialOptions(const std::string& path, const std::string& text,
                              const PlannerValues& values, const VehicleLimits& limits);

/// The shortest text that reads back as the same number, in planners.yaml and in reports.
std::string shortestText(double value);

}  // namespace forge
