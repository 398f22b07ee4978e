#pragma once

#include <string>

namespace forge {

/// Owns a POSIX file descriptor and closes it on destruction.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;

  bool isOpen() const { return value_ >= 0; }
  int get() const { return value_; }
  /// Returns the descriptor and gives up ownership.
  int release();

  /// Takes the file's exclusive lock (flock) without waiting. Returns false with errno EWOULDBLOCK
  /// if another holder has it, with another errno if the file system has no locks. The lock is
  /// released with the last copy of the descriptor, so also when a process is killed.
  bool lock() const;

  /// Returns true if `path` is still this file and not a symbolic link.
  bool isNamed(const std::string& path) const;

 private:
  int value_;
};

/// Flushes creations, renames and removals in the folder of `path` to the disk, as far as the file
/// system supports it. Returns false with errno on failure.
bool syncFolderOf(const std::string& path);

}  // namespace forge
