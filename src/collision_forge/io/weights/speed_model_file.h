#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "collision_forge/attack/forecast/speed_model.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Names file, line, field and value.
struct SpeedModelFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a file of data/weights, whose README describes it. Throws SpeedModelFileError for a file
/// that is missing or malformed.
SpeedModel readSpeedModel(const std::string& path);

/// Writes the same, numbers rounded to five digits. Throws as AsideFile does.
void writeSpeedModel(const SpeedModel& model, const std::string& path);

/// The model that is named; null when none is. Throws SpeedModelFileError.
std::shared_ptr<const SpeedForecaster> loadSpeedForecaster(const ModelOptions& options);

}  // namespace forge
