#pragma once

#include <cstddef>
#include <string>

#include "collision_forge/base/files/aside_file.h"

namespace forge {

/// Writes a self-contained HTML page: the program, compressed records that the program reads on
/// demand, and an index that it reads first.
class PageFile {
 public:
  /// Writes the start of the page to an AsideFile for `path`. Throws as AsideFile.
  explicit PageFile(const std::string& path);

  /// Appends a record, any text (usually JSON), in compressed form (deflatedText()). Returns its
  /// index in the page, from 0 on. Throws as deflatedText(); commit() reports a failed write.
  std::size_t add(const std::string& record);

  /// Writes `index` (JSON, compressed) and the end of the page, and puts the file in its place,
  /// over an older one. Must be the last call. Throws as AsideFile::commit() and deflatedText().
  /// Without commit() the page does not appear.
  void commit(const std::string& index);

 private:
  AsideFile file_;
  std::size_t count_ = 0;  ///< number of records
};

}  // namespace forge
