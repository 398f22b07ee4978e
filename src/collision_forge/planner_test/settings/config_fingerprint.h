#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Returns the fingerprints of everything in a configuration that results depend on, to check
/// whether a run may be resumed: the values of every product file ("config/NAME") and the models
/// that it names ("speed_model", "pattern_network"). Excludes the files for bags with attacks,
/// drawing, pages, exports, request lists, live scenes, encoding, tuning and ranks. Throws
/// std::runtime_error if a file cannot be read.
std::map<std::string, std::string> fingerprintsOf(const Config& config, const ConfigFolder& folder);

/// Returns only the fingerprints of files in config/, for training, which needs no model.
std::map<std::string, std::string> configFingerprints(const ConfigFolder& folder);

/// Returns one fingerprint() of all fingerprintsOf().
std::string fingerprintOfAll(const Config& config, const ConfigFolder& folder);

/// Returns the fingerprint() of a configuration file's values as text: an overlay changes it,
/// comments and layout do not.
std::string fingerprintOfValues(const ConfigFolder& folder, const std::string& file);

/// Returns the fingerprint() of a file's bytes as text. Throws std::runtime_error if it cannot be
/// read.
std::string fingerprintOfFile(const std::string& path);

/// Adds the fingerprints of a model's weights under its name; weights of folds as "NAME fold 1" and
/// so on.
void addWeights(const std::string& model, const std::vector<std::string>& paths,
                std::map<std::string, std::string>& found);

}  // namespace forge
