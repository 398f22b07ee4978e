#pragma once

#include <ext/stdio_filebuf.h>

#include <ostream>
#include <string>

namespace forge {

/// Writes a file atomically: to `path` + ".part" first, which commit() flushes to the disk and
/// renames to `path`. Without commit() the destructor deletes the part and leaves `path` unchanged.
/// Concurrent writers of one path use parts of their own (".2.part" and so on); the last commit()
/// wins. The part is locked (flock), so the next writer of `path` recognises and deletes the part
/// of a killed process. All errors are std::runtime_error naming `path`.
class AsideFile {
 public:
  /// Creates the part. Throws if it cannot be created, if `path` is a folder or a device, and if
  /// PATH.part holds items of an unfinished run (ResumableFile), which stay unchanged.
  explicit AsideFile(const std::string& path);
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  /// Returns the path of the part, for writers that need a file name.
  const std::string& partPath() const { return part_path_; }
  /// Returns the binary stream to the part, valid as long as this object. commit() reports failed
  /// writes.
  std::ostream& stream() { return stream_; }

  /// Flushes the part and renames it to `path`, replacing a file there. Throws if the stream could
  /// not be written in full or the part cannot be renamed; `path` is then unchanged. Also throws if
  /// the folder cannot be flushed to the disk; the new file is then at `path`. Call it once.
  void commit();

 private:
  /// Throws std::runtime_error with `path` and the text of errno.
  [[noreturn]] void fail() const;

  std::string path_;
  std::string part_path_;
  __gnu_cxx::stdio_filebuf<char> buffer_;  // of the locked descriptor
  std::ostream stream_;
  bool is_committed_ = false;
};

/// Writes `text` to `path` with an AsideFile, byte for byte. Throws as AsideFile.
void writeText(const std::string& path, const std::string& text);

}  // namespace forge
