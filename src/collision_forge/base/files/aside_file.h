#pragma once

#include <ext/stdio_filebuf.h>

#include <ostream>
#include <string>

namespace forge {

/// A file that is written beside its place, to `path` + ".part", and moved there when it is
/// complete and on the disk. Without commit() the destructor removes what was written and leaves
/// `path` as it was. Of several who write `path` at once each has a file of its own (".2.part" and
/// so on), and the last commit() stands. The file is locked: what a process left that was killed is
/// told by that, and removed by the next who writes `path`. Errors are std::runtime_error naming
/// `path`.
class AsideFile {
 public:
  /// Makes the file. Throws if it cannot be made, if `path` is a folder or a device, and if
  /// PATH.part holds items of an unfinished run (a ResumableFile), which are left as they are.
  explicit AsideFile(const std::string& path);
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  /// For those who write by name.
  const std::string& partPath() const { return part_path_; }
  /// For all others; binary. A write that fails is told by commit().
  std::ostream& stream() { return stream_; }

  /// Moves the file to `path`, replacing what is there. Throws when not all of the stream could be
  /// written, and when the file cannot be moved.
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::string path_;
  std::string part_path_;
  __gnu_cxx::stdio_filebuf<char> buffer_;  // of a descriptor that is locked
  std::ostream stream_;
  bool is_committed_ = false;
};

/// All of a file at once, written aside.
void writeText(const std::string& path, const std::string& text);

}  // namespace forge
