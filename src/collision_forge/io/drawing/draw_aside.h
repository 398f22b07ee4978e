#pragma once

#include <stdexcept>
#include <string>

#include "collision_forge/base/files/aside_file.h"

namespace forge {

/// Calls `write` with a stream to an AsideFile for `path`, so that `path` never holds half a
/// picture. Throws std::runtime_error naming the file if anything fails.
template <typename Write>
void drawAside(const std::string& path, const Write& write) {
  AsideFile file(path);
  std::ostream& stream = file.stream();
  try {
    write(stream);
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot draw " + path + ": " + error.what());
  }
  file.commit();
}

}  // namespace forge
