#pragma once

#include <cstddef>
#include <string>

#include "collision_forge/base/files/aside_file.h"

namespace forge {

/// A page that holds everything it shows: the program, records that it unpacks when they are
/// looked at, and an index that it reads first.
class PageFile {
 public:
  /// Throws as AsideFile does.
  explicit PageFile(const std::string& path);

  /// Adds a record and returns its place, from 0 on.
  std::size_t add(const std::string& record);

  /// The index and the end of the page. Throws as AsideFile::commit().
  void commit(const std::string& index);

 private:
  AsideFile file_;
  std::size_t count_ = 0;
};

}  // namespace forge
