#pragma once

#include <string>

#include "collision_forge/base/files/descriptor.h"

namespace forge {

/// Keeps other OutputLocks, of this or another process, from the same output while this object
/// exists. Locks a file that holds the process id: FOLDER/.lock, or FILE.lock beside a file. The
/// unlocked lock file of a killed process is reused. Another file of that name stays unchanged and
/// is an error. The destructor removes the lock file.
class OutputLock {
 public:
  static constexpr const char* kFileName = ".lock";  ///< name in a folder, ending beside a file
  /// Locks a folder and returns the lock; does not wait. Creates the folder if it is missing; the
  /// destructor then removes it if it is still empty. Throws std::runtime_error naming the output
  /// if it cannot be locked, with the id of the process that holds the lock.
  static OutputLock ofFolder(const std::string& folder);
  /// Locks a file that need not exist, and returns the lock. Throws as ofFolder(), and if `path`
  /// exists and is not a file.
  static OutputLock ofFile(const std::string& path);

  ~OutputLock();
  OutputLock(OutputLock&&) noexcept = default;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  /// `output` names the output in messages.
  OutputLock(const std::string& output, std::string lock_path);

  std::string lock_path_;
  Descriptor lock_;
  std::string made_folder_;  ///< empty if the folder existed
};

}  // namespace forge
