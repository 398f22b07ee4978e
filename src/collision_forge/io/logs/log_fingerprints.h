#pragma once

#include <map>
#include <string>

namespace forge {

/// Returns fingerprintOfTree() of the log data on which results depend, by kind. `path`: folder or
/// file of the log. For a nuScenes root (a folder with a subfolder maps): "tables" (.json files of
/// its folder `version`; left out if `version` is "") and "maps" (.json files of the map expansion;
/// left out if missing); for another folder or a file: "logs" (all files). Throws
/// std::runtime_error for a file that cannot be read.
std::map<std::string, std::string> logFingerprints(const std::string& path,
                                                   const std::string& version);

}  // namespace forge
