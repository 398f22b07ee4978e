#include "collision_forge/io/batch/output.h"

#include <filesystem>
#include <set>

namespace forge {

OutputLocks lockFolders(const std::vector<std::string>& folders) {
  OutputLocks locks;
  std::set<std::filesystem::path> locked;
  for (const std::string& folder : folders) {
    if (folder.empty() || !locked.insert(std::filesystem::weakly_canonical(folder)).second) {
      continue;
    }
    locks.push_back(OutputLock::ofFolder(folder));
  }
  return locks;
}

OutputLocks lockFile(const std::string& path) {
  OutputLocks locks;
  locks.push_back(OutputLock::ofFile(path));
  return locks;
}

}  // namespace forge
