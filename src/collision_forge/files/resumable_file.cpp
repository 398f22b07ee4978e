#include "collision_forge/files/resumable_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "collision_forge/files/aside_file.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWith(const std::string& path, const std::string& problem) {
  throw std::runtime_error(path + ": " + problem + ": " + std::strerror(errno));
}

std::string optionsPath(const std::string& path) { return path + ".options"; }

ResumableFile::Options readOptions(const std::string& path) {
  std::ifstream file(path);
  ResumableFile::Options options;
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) options[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return options;
}

void writeOptions(const std::string& path, const ResumableFile::Options& options) {
  AsideFile file(path);
  for (const auto& [name, value] : options) file.stream() << name << ": " << value << '\n';
  file.commit();
}

/// Empty where there is none.
std::string valueOf(const ResumableFile::Options& options, const std::string& name) {
  const auto found = options.find(name);
  return found == options.end() ? "" : found->second;
}

/// Refuses to go on with `what`, which was begun with other options than these.
void checkOptions(const std::string& path, const std::string& what,
                  const ResumableFile::Options& options) {
  const std::string remedy =
      "; finish it as it was begun, or remove it to begin anew, or write elsewhere";
  if (!fs::exists(optionsPath(path))) {
    throw std::runtime_error(what + ": is there, but not " + optionsPath(path) +
                             ", which says what it was made with" + remedy);
  }
  const ResumableFile::Options before = readOptions(optionsPath(path));
  ResumableFile::Options all = options;
  all.insert(before.begin(), before.end());
  for (const auto& entry : all) {
    const std::string& name = entry.first;
    const std::string was = valueOf(before, name);
    const std::string is = valueOf(options, name);
    if (was == is) continue;
    throw std::runtime_error(what + ": was begun with " + name + " = " + was + ", now " + name +
                             " = " + is + remedy);
  }
}

}  // namespace

ResumableFile::ResumableFile(const std::string& path, const Options& options,
                             const ItemLayout& layout)
    : path_(path), part_(path + ".part"), layout_(layout) {
  if (fs::exists(path_)) {
    checkOptions(path_, path_, options);
    is_complete_ = true;
    return;
  }
  descriptor_ = ::open(part_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) failWith(part_, "cannot be opened");
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) failWith(part_, "is being written");
    if (fs::file_size(part_) == 0) {
      writeOptions(optionsPath(path_), options);
    } else {
      checkOptions(path_, part_, options);
    }
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

ResumableFile::~ResumableFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void ResumableFile::checkHeader(const std::string& path, const std::string& line) const {
  if (line == layout_.header) return;
  throw std::runtime_error(path + ": line 1: \"" + line + "\" is another header");
}

std::size_t ResumableFile::resume(
    const std::function<void(const std::string& where, const std::string& lines)>& on_item) {
  const std::string& path = is_complete_ ? path_ : part_;
  std::ifstream file(path);
  std::size_t items = 0;
  std::size_t line_number = 0;
  std::size_t lines = 0;  // of the item
  std::string item;
  std::int64_t size = 0;
  for (std::string line; std::getline(file, line) && !file.eof();) {
    if (++line_number == 1 && !layout_.header.empty()) {
      checkHeader(path, line);
      size += static_cast<std::int64_t>(line.size()) + 1;
      continue;
    }
    item += (lines == 0 ? "" : "\n") + line;
    if (++lines < layout_.lines_per_item) continue;
    on_item(path + ": line " + std::to_string(line_number + 1 - lines), item);
    size += static_cast<std::int64_t>(item.size()) + 1;
    ++items;
    lines = 0;
    item.clear();
  }
  if (file.bad()) failWith(path, "cannot be read");
  if (!is_complete_) cutTo(size);
  return items;
}

void ResumableFile::cutTo(std::int64_t size) {
  if (::ftruncate(descriptor_, size) != 0) failWith(part_, "cannot be cut to its complete items");
  size_ = size;
  if (size == 0 && !layout_.header.empty()) append(layout_.header);
}

void ResumableFile::append(const std::string& lines) {
  const std::string bytes = lines + "\n";
  for (std::size_t written = 0; written < bytes.size();) {
    const ssize_t count = ::write(descriptor_, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int reason = errno;
      // Where this fails too, resume() cuts the rest off.
      [[maybe_unused]] const int cut = ::ftruncate(descriptor_, size_);
      errno = reason;
      failWith(part_, "cannot be written");
    }
    written += static_cast<std::size_t>(count);
  }
  size_ += static_cast<std::int64_t>(bytes.size());
}

void ResumableFile::complete() {
  if (::fsync(descriptor_) != 0) failWith(part_, "cannot be written");
  if (std::rename(part_.c_str(), path_.c_str()) != 0) failWith(path_, "cannot be written");
}

}  // namespace forge
