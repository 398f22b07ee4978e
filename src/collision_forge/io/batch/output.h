#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/files/output_lock.h"

namespace forge {

/// Locks on the output folders or files of a run. Names that are "" or repeated are skipped. Throw
/// as OutputLock.
using OutputLocks = std::vector<OutputLock>;
OutputLocks lockFolders(const std::vector<std::string>& folders);
OutputLocks lockFile(const std::string& path);

}  // namespace forge
