#pragma once

#include <string>
#include <vector>

namespace forge {

/// Tells whether files are what they were: their number and a fingerprint() of their names and
/// contents. Of a file above 64 MiB, as the tables of nuScenes are (1 GB), it is of the size, the
/// time of the last change and the first and last MiB. Throws std::runtime_error naming a file that
/// cannot be read.
std::string fingerprintOfFiles(const std::vector<std::string>& paths);

/// The same of all files under a folder whose names have this ending (empty: any), sorted, or of
/// `path` itself where it is a file. Links to folders are not followed, `path` apart.
std::string fingerprintOfTree(const std::string& path, const std::string& ending = "");

}  // namespace forge
