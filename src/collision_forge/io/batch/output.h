#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/files/output_lock.h"

namespace forge {

/// Locks on the output folders or files of a run; released on destruction.
using OutputLocks = std::vector<OutputLock>;
/// Lock the folders, or the file. Names that are "" or repeated are skipped. Throw as OutputLock if
/// another process holds a lock.
OutputLocks lockFolders(const std::vector<std::string>& folders);
OutputLocks lockFile(const std::string& path);

}  // namespace forge
