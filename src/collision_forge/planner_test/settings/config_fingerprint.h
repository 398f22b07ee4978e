#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// What results depend on in a configuration read from `folder`, to tell whether a run may go on:
/// the fingerprint() of the values of every file of the product ("config/NAME") except those for
/// bags with attacks, drawing, pages, exports, lists of requests, live scenes, encoding, tuning and
/// ranks, and the fingerprints of the models that it names ("speed_model",
/// "pattern_network"). Throws std::runtime_error for a file that cannot be read.
std::map<std::string, std::string> fingerprintsOf(const Config& config, const ConfigFolder& folder);

/// The part of these that is of the files of config/, for training, which needs none of the models.
std::map<std::string, std::string> configFingerprints(const ConfigFolder& folder);

/// The fingerprint() of fingerprintsOf(), one for all.
std::string fingerprintOfAll(const Config& config, const ConfigFolder& folder);

/// The fingerprint() of the values of a file of the configuration, in words: an overlay changes it,
/// comments and layout do not.
std::string fingerprintOfValues(const ConfigFolder& folder, const std::string& file);

/// The fingerprint() of a file's bytes, in words. Throws std::runtime_error for one that cannot be
/// read.
std::string fingerprintOfFile(const std::string& path);

/// Adds the fingerprints of a model's weights, by its name; those of folds as "NAME fold 1" and on.
void addWeights(const std::string& model, const std::vector<std::string>& paths,
                std::map<std::string, std::string>& found);

}  // namespace forge
