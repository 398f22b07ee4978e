#include "collision_forge/base/files/descriptor.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

namespace forge {

Descriptor::~Descriptor() {
  if (isOpen()) ::close(value_);
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(value_, other.value_);
  return *this;
}

int Descriptor::release() { return std::exchange(value_, -1); }

bool Descriptor::lock() const { return ::flock(value_, LOCK_EX | LOCK_NB) == 0; }

bool Descriptor::isNamed(const std::string& path) const {
  struct stat own = {};
  struct stat named = {};
  return ::fstat(value_, &own) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

bool syncFolderOf(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  const Descriptor folder(
      ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // A folder without read permission may be writable, and some file systems cannot sync folders.
  if (!folder.isOpen()) return errno == EACCES;
  return ::fsync(folder.get()) == 0 || errno == EINVAL;
}

}  // namespace forge
