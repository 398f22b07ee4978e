#include "collision_forge/files/output_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace forge {
namespace {

namespace fs = std::filesystem;

/// As "process 1234".
std::string holderOf(const Descriptor& lock) {
  char digits[24];
  const ssize_t count = ::pread(lock.get(), digits, sizeof(digits), 0);
  return count > 0 ? "process " + std::string(digits, static_cast<std::size_t>(count))
                   : "another process";
}

}  // namespace

OutputLock OutputLock::ofFolder(const std::string& folder) {
  std::error_code error;
  const bool is_new = fs::create_directories(folder, error);
  if (error) throw std::runtime_error(folder + ": cannot be made: " + error.message());
  OutputLock lock(folder, (fs::path(folder) / kFileName).string());
  if (is_new) lock.made_folder_ = folder;
  return lock;
}

OutputLock OutputLock::ofFile(const std::string& path) {
  if (fs::exists(path) && !fs::is_regular_file(path)) {
    throw std::runtime_error(path + ": is there and no file");
  }
  return OutputLock(path, path + kFileName);
}

OutputLock::OutputLock(const std::string& output, std::string lock_path)
    : lock_path_(std::move(lock_path)) {
  const auto fail = [&] {
    throw std::runtime_error(output + ": cannot be written: " + lock_path_ + ": " +
                             std::strerror(errno));
  };
  while (!lock_.isOpen()) {
    Descriptor file(
        ::open(lock_path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
    if (!file.isOpen()) fail();
    if (!file.lock()) {
      if (errno != EWOULDBLOCK) fail();
      throw std::runtime_error(output + ": is being written by " + holderOf(file));
    }
    // Else who had it before has ended meanwhile, and removed it.
    if (file.isNamed(lock_path_)) lock_ = std::move(file);
  }
  const std::string number = std::to_string(::getpid());
  // A full disk is told by who writes the output; without the number the lock is as good.
  [[maybe_unused]] const bool is_told = ::ftruncate(lock_.get(), 0) == 0 &&
                                        ::pwrite(lock_.get(), number.data(), number.size(), 0) > 0;
}

OutputLock::~OutputLock() {
  if (!lock_.isOpen()) return;
  ::unlink(lock_path_.c_str());
  if (!made_folder_.empty()) ::rmdir(made_folder_.c_str());
}

}  // namespace forge
