#include "collision_forge/base/files/output_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Returns the first bytes of a lock file; a real lock file is shorter.
std::string firstBytesOf(const Descriptor& lock) {
  char bytes[24];
  const ssize_t count = ::pread(lock.get(), bytes, sizeof(bytes), 0);
  return {bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

/// Returns the holder, as "process 1234".
std::string holderOf(const Descriptor& lock) {
  const std::string number = firstBytesOf(lock);
  return number.empty() ? "another process" : "process " + number;
}

/// Returns true for the content of a lock file, also of one left by a killed process.
bool isLock(const std::string& begin) {
  return std::all_of(begin.begin(), begin.end(),
                     [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

}  // namespace

OutputLock OutputLock::ofFolder(const std::string& folder) {
  std::error_code error;
  const bool is_new = fs::create_directories(folder, error);
  if (error) throw std::runtime_error(folder + ": cannot be created: " + error.message());
  OutputLock lock(folder, (fs::path(folder) / kFileName).string());
  if (is_new) lock.made_folder_ = folder;
  return lock;
}

OutputLock OutputLock::ofFile(const std::string& path) {
  if (fs::exists(path) && !fs::is_regular_file(path)) {
    throw std::runtime_error(path + ": exists and is not a file");
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
    if (!file.isNamed(lock_path_)) continue;  // the former holder ended and removed it
    if (!isLock(firstBytesOf(file))) {
      throw std::runtime_error(
          output + ": cannot be written: " + lock_path_ +
          ": is not a lock file of this program; delete it, or choose another output");
    }
    lock_ = std::move(file);
  }
  const std::string number = std::to_string(::getpid());
  // A full disk is reported when the output is written; the lock works without the number.
  [[maybe_unused]] const bool is_written =
      ::ftruncate(lock_.get(), 0) == 0 &&
      ::pwrite(lock_.get(), number.data(), number.size(), 0) > 0;
}

OutputLock::~OutputLock() {
  if (!lock_.isOpen()) return;
  ::unlink(lock_path_.c_str());
  if (!made_folder_.empty()) ::rmdir(made_folder_.c_str());
}

}  // namespace forge
