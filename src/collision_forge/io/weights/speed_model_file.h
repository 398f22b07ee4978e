#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "collision_forge/attack/forecast/speed_model.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Thrown for a speed model file that cannot be used. Names file, line, field and value.
struct SpeedModelFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a speed model file (format: README of data/weights): a line per model, first the one
/// trained on all scenes, then its folds. Throws SpeedModelFileError for a file that is missing,
/// empty or malformed.
SpeedModel readSpeedModel(const std::string& path);

/// Writes a file that readSpeedModel() reads, numbers rounded to five significant digits. Throws as
/// AsideFile.
void writeSpeedModel(const SpeedModel& model, const std::string& path);

/// Loads the file at `options.speed_model`; null if that path is "". Throws SpeedModelFileError.
std::shared_ptr<const SpeedForecaster> loadSpeedForecaster(const ModelOptions& options);

}  // namespace forge
