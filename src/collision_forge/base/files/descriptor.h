#pragma once

#include <string>

namespace forge {

/// Owns a POSIX file descriptor and closes it on destruction.
class Descriptor {
 public:
  /// Takes ownership of an open descriptor; -1: of none.
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;

  /// Returns true if this object owns a descriptor.
  bool isOpen() const { return value_ >= 0; }
  /// Returns the descriptor, which stays owned; -1: none.
  int get() const { return value_; }
  /// Returns the descriptor (-1: none) without closing it; this object then owns none.
  int release();

  /// Takes the file's exclusive lock (flock) without waiting. Returns true if this descriptor then
  /// has the lock, false with errno EWOULDBLOCK if another holder has it, with another errno if the
  /// file system has no locks. The lock is released with the last copy of the descriptor, so also
  /// when a process is killed.
  bool lock() const;

  /// Returns true if `path` names this open file, so that it was not removed or replaced, and is
  /// not a symbolic link.
  bool isNamed(const std::string& path) const;

 private:
  int value_;
};

/// Flushes creations, renames and removals in the folder that contains `path` (the working folder
/// for a bare name) to the disk, as far as the file system supports it. Returns true if there is
/// nothing more to flush, false with errno on failure.
bool syncFolderOf(const std::string& path);

}  // namespace forge
