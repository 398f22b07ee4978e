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

/// Returns the same for the files below the folder `path`, at any depth, whose names end in
/// `ending` ("": all), sorted by path, with their paths relative to the folder as names. If `path`
/// is a file, returns fingerprintOfFiles() of it, whatever its ending. Does not follow links to
/// folders, except `path`. Throws std::runtime_error if `path` does not exist or a file cannot be
/// read.
std::string fingerprintOfTree(const std::string& path, const std::string& ending = "");

}  // namespace forge
