#pragma once

#include <string>
#include <vector>

namespace forge {

/// Returns a text by which callers detect changed files, "3 files, fingerprint 0123456789abcdef":
/// the number of files and a fingerprint() of their names (without folders) and contents, in the
/// given order. For a file above 64 MiB (the tables of nuScenes have 1 GB) it covers the size, the
/// time of the last change and the first and last MiB. Throws std::runtime_error naming a file that
/// cannot be read.
std::string fingerprintOfFiles(const std::vector<std::string>& paths);

/// Returns the same for all files under the folder `path`, with their paths relative to it as
/// names, sorted, if these end in `ending` ("": all); or for `path` itself if it is no folder. Does
/// not follow links to folders, except `path`.
std::string fingerprintOfTree(const std::string& path, const std::string& ending = "");

}  // namespace forge
