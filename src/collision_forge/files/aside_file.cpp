#include "collision_forge/files/aside_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace forge {

AsideFile::AsideFile(const std::string& path) : path_(path), part_path_(path + ".part") {
  if (std::filesystem::exists(path_) && !std::filesystem::is_regular_file(path_)) {
    throw std::runtime_error(path_ + ": is there and no file");
  }
}

AsideFile::~AsideFile() { std::remove(part_path_.c_str()); }

std::ostream& AsideFile::stream() {
  if (!stream_.is_open()) {
    stream_.open(part_path_, std::ios::binary);
    if (!stream_) fail();
  }
  return stream_;
}

void AsideFile::commit() {
  if (stream_.is_open()) {
    const bool kept_up = stream_.good();
    stream_.close();
    if (!kept_up) {  // errno may be of something else by now
      throw std::runtime_error(path_ + ": cannot be written to its end; is the disk full?");
    }
    if (!stream_) fail();
  }
  if (std::rename(part_path_.c_str(), path_.c_str()) != 0) fail();
}

void writeText(const std::string& path, const std::string& text) {
  AsideFile file(path);
  file.stream() << text;
  file.commit();
}

void AsideFile::fail() const {
  throw std::runtime_error(path_ + ": cannot be written: " + std::strerror(errno));
}

}  // namespace forge
