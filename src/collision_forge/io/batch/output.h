#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/files/output_lock.h"

namespace forge {

/// Locks on the output folders or files of a run; released on destruction.
using OutputLocks = std::vector<OutputLock>;
/// Locks the output folders. Names that are "" or denote an earlier folder are skipped. Throws as
/// OutputLock::ofFolder().
OutputLocks lockFolders(const std::vector<std::string>& folders);
/// Locks the output file `path`, which must not be "". Returns one lock. Throws as
/// OutputLock::ofFile().
OutputLocks lockFile(const std::string& path);

}  // namespace forge
