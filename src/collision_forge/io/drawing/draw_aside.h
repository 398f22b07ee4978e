#pragma once

#include <stdexcept>
#include <string>

#include "collision_forge/base/files/aside_file.h"

namespace forge {

/// A picture that `write` writes to a stream, aside and renamed, so that `path` never holds half of
/// one. Throws std::runtime_error that names the file for whatever fails.
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
