#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Returns, by name, the fingerprints ("fingerprint HEX") of everything in a configuration that
/// results depend on, to check whether a run may be resumed: the values of the product files
/// ("config/NAME.yaml") and the models that they name ("speed_model", "pattern_network"; left out
/// if none is named). The contents of other files that values name, as the planner file of
/// planners.yaml, do not count. `config` must have been read from `folder`. Excludes the files
/// attacked_bag, drawing, encoding, export, lidar, live, phrases, report, requests, topics_* and
/// tuning. Throws std::runtime_error if a file cannot be read.
std::map<std::string, std::string> fingerprintsOf(const Config& config, const ConfigFolder& folder);

/// Returns only the fingerprints of the files in config/, as fingerprintsOf(), for training, which
/// needs no model.
std::map<std::string, std::string> configFingerprints(const ConfigFolder& folder);

/// Returns one fingerprint() (the digits alone) of all names and texts of fingerprintsOf(). Throws
/// as fingerprintsOf().
std::string fingerprintOfAll(const Config& config, const ConfigFolder& folder);

/// Returns "fingerprint HEX" of the values (ConfigFolder::values()) of a file ("NAME.yaml") of the
/// configuration: an overlay changes it, comments and layout do not.
std::string fingerprintOfValues(const ConfigFolder& folder, const std::string& file);

/// Returns "fingerprint HEX" of a file's bytes. Throws std::runtime_error if the file cannot be
/// read.
std::string fingerprintOfFile(const std::string& path);

/// Adds fingerprintOfFile() of each of `paths`, the weights of one model, to `found`: the first
/// under the name `model`, the further ones, networks of folds, as "MODEL fold 1" and so on. Throws
/// std::runtime_error if a file cannot be read.
void addWeights(const std::string& model, const std::vector<std::string>& paths,
                std::map<std::string, std::string>& found);

}  // namespace forge
