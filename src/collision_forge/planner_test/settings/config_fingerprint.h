#pragma once

#include <map>
#include <string>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// What results depend on in a configuration read from `directory`, to tell whether a run may go
/// on: the fingerprint() of every .yaml file ("config/NAME") but those that are for bags with
/// attacks, drawing, pages, exports, lists of requests, live scenes, encoding, fitting, training
/// and tuning alone, and of the files of models that it names ("speed_model",
/// "pattern_network"). Throws std::runtime_error for a file that cannot be read.
std::map<std::string, std::string> fingerprintsOf(const Config& config,
                                                  const std::string& directory);

/// The part of these that is of the .yaml files, for training, which needs none of the models.
std::map<std::string, std::string> configFingerprints(const std::string& directory);

/// The fingerprint() of fingerprintsOf(), one for all.
std::string fingerprintOfAll(const Config& config, const std::string& directory);

/// The fingerprint() of a file's bytes, in words. Throws std::runtime_error for one that cannot be
/// read.
std::string fingerprintOfFile(const std::string& path);

}  // namespace forge
