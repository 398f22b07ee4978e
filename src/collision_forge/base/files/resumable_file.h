#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "collision_forge/base/files/descriptor.h"

namespace forge {

struct ItemLayout {
  std::string header;  ///< first line of the file; empty: none
  std::size_t lines_per_item = 1;
};

/// A file of items, each of a line or a few, that is written over several runs, if need be: items
/// go to PATH.part, which is moved to PATH when complete. PATH.options, which stays, holds what
/// they were made with, so that no run goes on with items of another. PATH.part.sums has a checksum
/// of every item of PATH.part, so that none is taken that was altered. Every item is written at
/// once: a process that is killed loses at most the item that it is writing.
class ResumableFile {
 public:
  /// What the items are made with, by name; neither names nor values hold line ends.
  using Options = std::map<std::string, std::string>;

  /// Opens PATH.part, new or from a run before. Throws std::runtime_error naming the file when it
  /// cannot be opened, when another process is writing it, and when PATH or PATH.part was begun
  /// with other options: which, and what they were.
  ResumableFile(const std::string& path, const Options& options, const ItemLayout& layout = {});

  /// True when PATH was completed by a run before: there is nothing to write.
  bool isComplete() const { return is_complete_; }

  /// Hands the complete items of PATH or PATH.part to `on_item` in order, with where they stand
  /// ("PATH.part: line 1"), cuts off what is incomplete or has no checksum yet, and returns their
  /// number. To be called once, before append(). Throws std::runtime_error for another header and
  /// an item that is not as it was written; that, and what `on_item` throws, leaves the file as it
  /// was.
  std::size_t resume(
      const std::function<void(const std::string& where, const std::string& lines)>& on_item);

  /// Writes an item, its lines without the last line end. Throws std::runtime_error when it cannot
  /// be written (a full disk, a limit): the items before it stay.
  void append(const std::string& lines);

  /// Moves PATH.part to PATH once it is on the disk.
  void complete();

 private:
  void checkHeader(const std::string& path, const std::string& line) const;
  void checkSum(const std::string& sum, const std::string& where) const;
  void cutTo(std::int64_t size, std::size_t items);
  void appendLines(const std::string& lines);

  std::string path_;
  std::string part_;
  std::string sums_path_;
  ItemLayout layout_;
  Descriptor file_;
  Descriptor sums_;
  std::int64_t size_ = 0;       // bytes of complete items
  std::int64_t sums_size_ = 0;  // bytes
  std::string sum_;             // of all items up to the last one
  bool is_complete_ = false;
};

}  // namespace forge
