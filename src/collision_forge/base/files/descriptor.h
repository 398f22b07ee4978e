#pragma once

#include <string>

namespace forge {

/// An open file of the system, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;

  bool isOpen() const { return value_ >= 0; }
  int get() const { return value_; }
  /// Gives the file away.
  int release();

  /// Takes the one lock that a file has, without waiting; false where somebody else has it, with
  /// errno EWOULDBLOCK, and where the file system has no locks. It ends with the last copy of the
  /// descriptor, so also with a process that is killed.
  bool lock() const;

  /// True where the file still has this name, which is no link.
  bool isNamed(const std::string& path) const;

 private:
  int value_;
};

/// Sees to it that what was made, renamed or removed in the folder of `path` is so on the disk, as
/// far as the file system can. False with errno where that fails.
bool syncFolderOf(const std::string& path);

}  // namespace forge
