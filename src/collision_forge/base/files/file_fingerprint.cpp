#include "collision_forge/base/files/file_fingerprint.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "collision_forge/base/files/descriptor.h"
#include "collision_forge/base/files/fingerprint.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kBlock = std::int64_t{1} << 20U;  // bytes
constexpr std::int64_t kWhole = 64 * kBlock;             // bytes; read in a tenth of a second

[[noreturn]] void fail(const std::string& path) {
  throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
}

/// Continues a fingerprint with the bytes [first, end) of a file.
std::string continued(const std::string& before, const Descriptor& file, const std::string& path,
                      std::int64_t first, std::int64_t end) {
  std::string block(static_cast<std::size_t>(kBlock), '\0');
  std::string found = before;
  for (std::int64_t at = first; at < end;) {
    const auto wanted = static_cast<std::size_t>(std::min(kBlock, end - at));
    const ssize_t count = ::pread(file.get(), block.data(), wanted, at);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path);
    if (count == 0) break;  // the file was truncated meanwhile
    found = fingerprint(block.substr(0, static_cast<std::size_t>(count)), found);
    at += count;
  }
  return found;
}

std::string continued(const std::string& before, const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status = {};
  if (!file.isOpen() || ::fstat(file.get(), &status) != 0) fail(path);
  const std::int64_t size = status.st_size;
  std::string facts = "\n" + std::to_string(size);
  if (size <= kWhole) return continued(fingerprint(facts, before), file, path, 0, size);
  facts +=
      " " + std::to_string(status.st_mtim.tv_sec) + " " + std::to_string(status.st_mtim.tv_nsec);
  const std::string begun = continued(fingerprint(facts, before), file, path, 0, kBlock);
  return continued(begun, file, path, size - kBlock, size);
}

/// Returns the fingerprint of files, given as pairs of name and path.
std::string fingerprintOfNamed(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string found;
  for (const auto& [name, path] : files) found = continued(fingerprint("\n" + name, found), path);
  return std::to_string(files.size()) + " files, fingerprint " + fingerprint("", found);
}

bool hasEnding(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::string fingerprintOfFiles(const std::vector<std::string>& paths) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& path : paths) files.emplace_back(fs::path(path).filename(), path);
  return fingerprintOfNamed(files);
}

std::string fingerprintOfTree(const std::string& path, const std::string& ending) {
  if (!fs::is_directory(path)) return fingerprintOfFiles({path});
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    const std::string found = entry.path().string();
    if (!entry.is_regular_file() || !hasEnding(found, ending)) continue;
    files.emplace_back(entry.path().lexically_relative(path), found);
  }
  std::sort(files.begin(), files.end());
  return fingerprintOfNamed(files);
}

}  // namespace forge
