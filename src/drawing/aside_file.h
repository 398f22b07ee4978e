#pragma once

#include <string>

namespace forge {

/// A file that is written beside its place and moved there when complete. Without commit() the
/// destructor removes what was written and leaves `path` as it was.
class AsideFile {
 public:
  explicit AsideFile(const std::string& path);
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  /// Where to write meanwhile: in the same folder as `path`.
  const std::string& temporaryPath() const { return temporary_path_; }

  /// Moves the file to `path`, replacing what is there. Throws std::runtime_error naming `path`.
  void commit();

 private:
  std::string path_;
  std::string temporary_path_;
};

}  // namespace forge
