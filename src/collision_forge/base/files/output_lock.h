#pragma once

#include <string>

#include "collision_forge/base/files/descriptor.h"

namespace forge {

/// Prevents other processes from writing the same output while this object exists. Locks a file
/// that holds the process id: FOLDER/.lock, or FILE.lock beside a file. The unlocked lock file of a
/// killed process is reused. Another file of that name stays unchanged and is an error.
class OutputLock {
 public:
  static constexpr const char* kFileName = ".lock";
  /// Creates the folder; the destructor removes it if it is still empty. Throws std::runtime_error
  /// naming the output, and the id of the process that holds the lock.
  static OutputLock ofFolder(const std::string& folder);
  /// Throws as ofFolder(), and if `path` exists and is not a file.
  static OutputLock ofFile(const std::string& path);

  ~OutputLock();
  OutputLock(OutputLock&&) noexcept = default;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  OutputLock(const std::string& output, std::string lock_path);

  std::string lock_path_;
  Descriptor lock_;
  std::string made_folder_;  ///< empty if the folder existed
};

}  // namespace forge
