#pragma once

#include <fstream>
#include <string>

namespace forge {

/// A file that is written beside its place, to `path` + ".part", and moved there when it is
/// complete. Without commit() the destructor removes what was written and leaves `path` as it was.
/// Errors are std::runtime_error naming `path`.
class AsideFile {
 public:
  /// Throws for a path that is there and no file, as a folder or a device.
  explicit AsideFile(const std::string& path);
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  /// For those who write by name.
  const std::string& partPath() const { return part_path_; }
  /// For all others; binary. Throws where the file cannot be made. A write that fails is told by
  /// commit().
  std::ostream& stream();

  /// Moves the file to `path`, replacing what is there. Throws when not all of the stream could be
  /// written, and when the file cannot be moved.
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  std::string part_path_;
  std::ofstream stream_;
};

/// All of a file at once, written aside.
void writeText(const std::string& path, const std::string& text);

}  // namespace forge
