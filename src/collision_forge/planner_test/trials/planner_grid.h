#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/base/config/section.h"
#include "collision_forge/planner_test/trials/options.h"

namespace forge {

/// Values of planners.yaml by the path of their key, e.g. "pdm.idm.min_gap".
using PlannerValues = std::map<std::string, double>;

/// Values to try for some of these keys; at least one per key, without duplicates, the values in
/// the order of the file.
using PlannerGrid = std::map<std::string, std::vector<double>>;

/// Returns the grid in section `planner` of a file like config/tuning.yaml. Throws ConfigError for
/// a missing or empty section, and for a value that is not a list of distinct numbers.
PlannerGrid readPlannerGrid(Section file, const std::string& planner);
/// As above, from the YAML file at `path`. Throws ConfigError if the file cannot be read or parsed,
/// too.
PlannerGrid readPlannerGrid(const std::string& path, const std::string& planner);

/// Returns the values that planners.yaml has now for the keys in the grid. `text`: content of the
/// file; `path`: its name for messages. Throws ConfigError, naming `path`, for a missing key or a
/// value that is not a number.
PlannerValues readPlannerValues(const std::string& path, const std::string& text,
                                const PlannerGrid& grid);

/// Returns `text` (content of planners.yaml) with these values inserted; everything else, comments
/// and numbers that equal their new value included, stays as written (the last line gets a line
/// end). Throws as readPlannerValues(), and ConfigError for a number in quotes.
std::string withPlannerValues(const std::string& path, const std::string& text,
                              const PlannerValues& values);

/// Returns the options in `text` (content of planners.yaml) with these values for the planner under
/// test; reactive traffic keeps the values in `text`. `limits`: the ego's strict limits. Throws
/// ConfigError, naming `path`, for an invalid key or value.
TrialOptions readTrialOptions(const std::string& path, const std::string& text,
                              const PlannerValues& values, const VehicleLimits& limits);

/// Returns the shortest text that parses to the same number.
std::string shortestText(double value);

}  // namespace forge
