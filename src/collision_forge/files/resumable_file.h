#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace forge {

/// A file of lines that is written over several runs, if need be: lines go to PATH.part, which is
/// moved to PATH when complete. PATH.options, which stays, holds what the lines were made with, so
/// that no run goes on with lines of another. Every line is written at once: a process that is
/// killed loses at most the line that it is writing.
class ResumableFile {
 public:
  /// What the lines are made with, by name; neither names nor values hold line ends.
  using Options = std::map<std::string, std::string>;

  /// Opens PATH.part, new or from a run before. Throws std::runtime_error naming the file when it
  /// cannot be opened, when another process is writing it, and when PATH or PATH.part was begun
  /// with other options: which, and what they were.
  ResumableFile(const std::string& path, const Options& options);
  ~ResumableFile();
  ResumableFile(const ResumableFile&) = delete;
  ResumableFile& operator=(const ResumableFile&) = delete;

  /// True when PATH was completed by a run before: there is nothing to write.
  bool isComplete() const { return is_complete_; }

  /// Hands the complete lines of PATH.part to `on_line` in order, with where they stand
  /// ("PATH.part: line 1"), cuts off an incomplete last one, and returns their number. To be called
  /// once, before append(). What `on_line` throws leaves the file as it was.
  std::size_t resume(
      const std::function<void(const std::string& where, const std::string& line)>& on_line);

  /// Writes a line; `line` holds no line end. Throws std::runtime_error when it cannot be written
  /// (a full disk, a limit): the lines before it stay.
  void append(const std::string& line);

  /// Moves PATH.part to PATH once it is on the disk.
  void complete();

 private:
  std::string path_;
  std::string part_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // bytes of complete lines
  bool is_complete_ = false;
};

/// FNV-1a of 64 bits in hexadecimal, to tell whether texts are the same; `before` continues one.
std::string fingerprint(const std::string& text, const std::string& before = "");

}  // namespace forge
