#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "collision_forge/base/files/descriptor.h"

namespace forge {

/// Format of a ResumableFile.
struct ItemLayout {
  std::string header;              ///< first line of the file, without its line end; "": none
  std::size_t lines_per_item = 1;  ///< at least 1
};

/// A file of items that may be written over several runs; an item is one line or a few. Items go to
/// PATH.part, which complete() renames to PATH. PATH.options, which stays, records the options of
/// the items, so that no run continues with other options. PATH.part.sums has a checksum per item,
/// which detects altered items. append() writes each item at once: a killed process loses at most
/// the item that it is writing.
class ResumableFile {
 public:
  /// Options that determine the items, values by name; neither names nor values may contain line
  /// ends, and names no ": ".
  using Options = std::map<std::string, std::string>;

  /// Opens PATH.part, new or from an earlier run. Throws std::runtime_error naming the file if it
  /// cannot be opened, if another process writes it, and if PATH or PATH.part was made with other
  /// options (the message gives the first that differs and both values; an absent option equals
  /// an empty value) or has no PATH.options.
  /// Opens nothing if PATH exists: see isComplete().
  ResumableFile(const std::string& path, const Options& options, const ItemLayout& layout = {});

  /// Returns true if an earlier run completed PATH: nothing is left to write, and only resume() may
  /// be called.
  bool isComplete() const { return is_complete_; }

  /// Calls `on_item` for each complete item of PATH or PATH.part in order, with its position
  /// ("PATH.part: line 1") and its lines, without the last line end. Then cuts off data of
  /// PATH.part that is incomplete or has no checksum, writes the header if there is none, and
  /// returns the number of items. Call it once, before append(). Throws std::runtime_error for
  /// another header or an altered item; an exception, also of `on_item`, leaves the file unchanged.
  std::size_t resume(
      const std::function<void(const std::string& where, const std::string& lines)>& on_item);

  /// Writes an item, the lines_per_item lines `lines` without the last line end. resume() must have
  /// been called. Throws std::runtime_error if it cannot be written (a full disk, a limit): earlier
  /// items stay.
  void append(const std::string& lines);

  /// Flushes PATH.part to the disk, renames it to PATH and removes the checksums. Throws
  /// std::runtime_error on failure. No member may be called afterwards.
  void complete();

 private:
  /// Throws std::runtime_error if `line`, the first of the file `path`, is not the header.
  void checkHeader(const std::string& path, const std::string& line) const;
  /// Throws std::runtime_error if `sum` is not the checksum sum_ of the items up to `where`.
  void checkSum(const std::string& sum, const std::string& where) const;
  /// Truncates PATH.part to `size` bytes and the checksums to `items` items; writes the header of
  /// an empty file.
  void cutTo(std::int64_t size, std::size_t items);
  /// Appends `lines` and a line end to PATH.part, without a checksum.
  void appendLines(const std::string& lines);

  std::string path_;
  std::string part_;
  std::string sums_path_;
  ItemLayout layout_;
  Descriptor file_;
  Descriptor sums_;
  std::int64_t size_ = 0;       // bytes of complete items
  std::int64_t sums_size_ = 0;  // bytes
  std::string sum_;             // checksum of all items so far
  bool is_complete_ = false;
};

}  // namespace forge
