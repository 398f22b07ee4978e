#pragma once

#include <string>

#include "collision_forge/base/files/descriptor.h"

namespace forge {

/// Keeps other processes from writing the same output, from before the work begins to its end. It
/// is the lock of a file that holds the number of the process: FOLDER/.lock, or FILE.lock beside a
/// file. What a killed process leaves is not locked, and is taken over; another file of that name
/// is left as it is, and is an error.
class OutputLock {
 public:
  /// Makes the folder, and removes it again where nothing was written to it. Throws
  /// std::runtime_error naming the output, where another process writes it that one's number.
  static constexpr const char* kFileName = ".lock";
  static OutputLock ofFolder(const std::string& folder);
  /// Also throws for a path that is there and no file.
  static OutputLock ofFile(const std::string& path);

  ~OutputLock();
  OutputLock(OutputLock&&) noexcept = default;
  OutputLock& operator=(OutputLock&&) = delete;

 private:
  OutputLock(const std::string& output, std::string lock_path);

  std::string lock_path_;
  Descriptor lock_;
  std::string made_folder_;  ///< empty: it was there
};

}  // namespace forge
