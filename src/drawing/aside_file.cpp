#include "drawing/aside_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace forge {

AsideFile::AsideFile(const std::string& path) : path_(path), temporary_path_(path + ".tmp") {}

AsideFile::~AsideFile() { std::remove(temporary_path_.c_str()); }

void AsideFile::commit() {
  if (std::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
    throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
  }
}

}  // namespace forge
