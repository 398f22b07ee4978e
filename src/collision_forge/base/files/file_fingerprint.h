#pragma once

#include <string>
#include <vector>

namespace forge {

/// Returns a text by which callers detect changed files: the number of files and a fingerprint() of
/// their names and contents. For a file above 64 MiB (the tables of nuScenes have 1 GB) it covers
/// the size, the time of the last change and the first and last MiB. Throws std::runtime_error
/// naming a file that cannot be read.
std::string fingerprintOfFiles(const std::vector<std::string>& paths);

/// Returns the same for all files under a folder, sorted, whose names end in `ending` ("": all), or
/// for `path` itself if it is a file. Does not follow links to folders, except `path`.
std::string fingerprintOfTree(const std::string& path, const std::string& ending = "");

}  // namespace forge
