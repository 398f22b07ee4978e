#include "collision_forge/base/files/resumable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/fingerprint.h"

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

/// Returns the value of an option; empty if it is not set.
std::string valueOf(const ResumableFile::Options& options, const std::string& name) {
  const auto found = options.find(name);
  return found == options.end() ? "" : found->second;
}

/// Throws std::runtime_error if `what` was made with other options than these.
void checkOptions(const std::string& path, const std::string& what,
                  const ResumableFile::Options& options) {
  if (!fs::exists(optionsPath(path))) {
    throw std::runtime_error(what + ": exists without " + optionsPath(path) +
                             ", the record of its options: delete it, or choose another --out");
  }
  const ResumableFile::Options before = readOptions(optionsPath(path));
  ResumableFile::Options all = options;
  all.insert(before.begin(), before.end());
  for (const auto& entry : all) {
    const std::string& name = entry.first;
    const std::string was = valueOf(before, name);
    const std::string is = valueOf(options, name);
    if (was == is) continue;
    throw std::runtime_error(what + ": exists and was made with " + name + " = " + was + ", not " +
                             is + ": reuse those options, delete it, or choose another --out");
  }
}

Descriptor openToAppend(const std::string& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!file.isOpen()) failWith(path, "cannot be opened");
  return file;
}

void cut(const Descriptor& file, const std::string& path, std::int64_t size) {
  if (::ftruncate(file.get(), size) != 0)
    failWith(path, "cannot be truncated to its complete items");
}

/// Writes all bytes or, if possible, none; `size` is the file's size before the call.
void appendTo(const Descriptor& file, const std::string& path, const std::string& bytes,
              std::int64_t size) {
  for (std::size_t written = 0; written < bytes.size();) {
    const ssize_t count = ::write(file.get(), bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int reason = errno;
      // If this fails too, resume() cuts off the rest.
      [[maybe_unused]] const int is_cut = ::ftruncate(file.get(), size);
      errno = reason;
      failWith(path, "cannot be written");
    }
    written += static_cast<std::size_t>(count);
  }
}

/// Bytes of one checksum in its file.
constexpr std::int64_t kSumBytes = 17;  // 16 digits and a line end

}  // namespace

ResumableFile::ResumableFile(const std::string& path, const Options& options,
                             const ItemLayout& layout)
    : path_(path), part_(path + ".part"), sums_path_(part_ + ".sums"), layout_(layout) {
  if (fs::exists(path_)) {
    checkOptions(path_, path_, options);
    is_complete_ = true;
    return;
  }
  file_ = openToAppend(part_);
  if (!file_.lock()) failWith(part_, "is being written by another process");
  if (fs::file_size(part_) == 0) {
    writeOptions(optionsPath(path_), options);
  } else {
    checkOptions(path_, part_, options);
  }
  sums_ = openToAppend(sums_path_);
}

void ResumableFile::checkHeader(const std::string& path, const std::string& line) const {
  if (line == layout_.header) return;
  throw std::runtime_error(path + ": line 1: \"" + line + "\" is not the expected header");
}

void ResumableFile::checkSum(const std::string& sum, const std::string& where) const {
  if (sum == sum_) return;
  throw std::runtime_error(where + ": was altered: its checksum in " + sums_path_ +
                           " differs; delete it and all lines after it to compute them again");
}

std::size_t ResumableFile::resume(
    const std::function<void(const std::string& where, const std::string& lines)>& on_item) {
  const std::string& path = is_complete_ ? path_ : part_;
  std::ifstream file(path);
  std::ifstream sums(sums_path_);
  std::size_t items = 0;
  std::size_t line_number = 0;
  std::size_t lines = 0;  // of the current item
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
    const std::string where = path + ": line " + std::to_string(line_number + 1 - lines);
    if (!is_complete_) {
      std::string sum;
      if (!std::getline(sums, sum) || sums.eof())
        break;  // the process was killed before it was written
      sum_ = fingerprint(item, sum_);
      checkSum(sum, where);
    }
    on_item(where, item);
    size += static_cast<std::int64_t>(item.size()) + 1;
    ++items;
    lines = 0;
    item.clear();
  }
  if (file.bad()) failWith(path, "cannot be read");
  if (!is_complete_) cutTo(size, items);
  return items;
}

void ResumableFile::cutTo(std::int64_t size, std::size_t items) {
  cut(file_, part_, size);
  sums_size_ = kSumBytes * static_cast<std::int64_t>(items);
  cut(sums_, sums_path_, sums_size_);
  size_ = size;
  if (size == 0 && !layout_.header.empty()) appendLines(layout_.header);
}

void ResumableFile::appendLines(const std::string& lines) {
  appendTo(file_, part_, lines + "\n", size_);
  size_ += static_cast<std::int64_t>(lines.size()) + 1;
}

void ResumableFile::append(const std::string& lines) {
  appendLines(lines);
  sum_ = fingerprint(lines, sum_);
  appendTo(sums_, sums_path_, sum_ + "\n", sums_size_);
  sums_size_ += kSumBytes;
}

void ResumableFile::complete() {
  if (::fsync(file_.get()) != 0) failWith(part_, "cannot be written");
  if (std::rename(part_.c_str(), path_.c_str()) != 0) failWith(path_, "cannot be written");
  if (!syncFolderOf(path_)) failWith(path_, "cannot be written");
  ::unlink(sums_path_.c_str());
}

}  // namespace forge
