#pragma once

#include <map>
#include <string>

namespace forge {

/// Returns fingerprintOfTree() of the log data on which results depend, by kind. For a nuScenes
/// root: "tables" (folder `version`; left out if it is "") and "maps" (the map expansion); for
/// another folder or a file: "logs". Throws std::runtime_error for a file that cannot be read.
std::map<std::string, std::string> logFingerprints(const std::string& path,
                                                   const std::string& version);

}  // namespace forge
