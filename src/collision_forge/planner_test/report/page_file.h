#pragma once

#include <cstddef>
#include <string>

#include "collision_forge/base/files/aside_file.h"

namespace forge {

/// Writes a self-contained HTML page: the program, compressed records that the program reads on
/// demand, and an index that it reads first.
class PageFile {
 public:
  /// Starts the page. Throws as AsideFile.
  explicit PageFile(const std::string& path);

  /// Adds a record and returns its index, from 0 on.
  std::size_t add(const std::string& record);

  /// Writes the index and the end of the page. Throws as AsideFile::commit().
  void commit(const std::string& index);

 private:
  AsideFile file_;
  std::size_t count_ = 0;
};

}  // namespace forge
