#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/files/output_lock.h"

namespace forge {

/// What the master holds while a run writes to these folders or files; nothing in other ranks.
/// Empty names are left out, and what is named twice is locked once. Throws as OutputLock.
using OutputLocks = std::vector<OutputLock>;
OutputLocks lockFolders(const std::vector<std::string>& folders);
OutputLocks lockFile(const std::string& path);

}  // namespace forge
