#include "collision_forge/base/files/aside_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "collision_forge/base/files/descriptor.h"

namespace forge {
namespace {

/// Largest number of concurrent writers of one path.
constexpr int kWriters = 1000;

/// Removes a part that no process holds. Returns true if no file is there afterwards.
bool removeLeftOver(const std::string& part) {
  const Descriptor left(::open(part.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!left.isOpen()) return errno == ENOENT;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(part))) return false;
  if (!left.lock()) return false;
  // Only the holder of the lock removes the file, so the name is still valid here.
  return !left.isNamed(part) || ::unlink(part.c_str()) == 0;
}

/// Returns a new, locked file; not open, with errno, if a part in use is there.
Descriptor makePart(const std::string& part) {
  while (true) {
    constexpr int kFlags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    Descriptor made(::open(part.c_str(), kFlags, 0666));
    if (made.isOpen()) {
      // Before it was locked, another process may have removed it as a left-over.
      const bool is_taken = !made.lock() && errno == EWOULDBLOCK;
      if (!is_taken && made.isNamed(part)) return made;
    } else if (errno != EEXIST) {
      return made;
    } else if (!removeLeftOver(part)) {
      errno = EEXIST;
      return made;
    }
  }
}

}  // namespace

AsideFile::AsideFile(const std::string& path) : path_(path), stream_(&buffer_) {
  if (std::filesystem::exists(path_) && !std::filesystem::is_regular_file(path_)) {
    throw std::runtime_error(path_ + ": exists and is not a file");
  }
  if (std::filesystem::exists(path_ + ".part") && std::filesystem::exists(path_ + ".part.sums")) {
    throw std::runtime_error(path_ + ": an unfinished run is in " + path_ +
                             ".part: run its command again to finish it, delete " + path_ +
                             ".part, or choose another output");
  }
  Descriptor part;
  for (int writer = 1; writer <= kWriters && !part.isOpen(); ++writer) {
    part_path_ = path_ + (writer == 1 ? "" : "." + std::to_string(writer)) + ".part";
    errno = 0;
    part = makePart(part_path_);
    if (!part.isOpen() && errno != EEXIST) fail();
  }
  if (!part.isOpen()) fail();
  buffer_ = __gnu_cxx::stdio_filebuf<char>(part.release(), std::ios::out | std::ios::binary);
}

AsideFile::~AsideFile() {
  if (!is_committed_) ::unlink(part_path_.c_str());
}

void AsideFile::commit() {
  if (!stream_.good()) {  // errno may be of another call by now
    throw std::runtime_error(path_ + ": could not be written completely; is the disk full?");
  }
  if (!stream_.flush() || ::fsync(buffer_.fd()) != 0) fail();
  if (std::rename(part_path_.c_str(), path_.c_str()) != 0) fail();
  is_committed_ = true;
  if (!syncFolderOf(path_)) fail();
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
