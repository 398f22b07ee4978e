#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/speed_profiles.h"

namespace forge {

/// Names file, line and value.
struct SpeedProfilesFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a CSV file of data/speed_profiles. The first line names the columns, as
/// writeSpeedProfiles() writes them; each other line is a row of SpeedSituations. Throws
/// SpeedProfilesFileError for a file that is missing or malformed, or has a value beyond +-150.
SpeedSituations readSpeedSituations(const std::string& path);

/// The same, to forecast by.
SpeedProfiles readSpeedProfiles(const std::string& path, const SpeedProfileOptions& options);

/// Writes rows, numbers to the third decimal. Throws as AsideFile does.
void writeSpeedProfiles(const std::vector<SpeedProfileRow>& rows, const std::string& path);

}  // namespace forge
