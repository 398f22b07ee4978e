#pragma once

#include <map>
#include <string>

namespace forge {

/// What results depend on in logs, by what it is, as fingerprintOfTree() tells it. Of a nuScenes
/// root "tables", those of `version` (none where it is empty), and "maps", the expansion; of
/// another folder, or a file, "logs". Throws std::runtime_error for what cannot be read.
std::map<std::string, std::string> logFingerprints(const std::string& path,
                                                   const std::string& version);

}  // namespace forge
