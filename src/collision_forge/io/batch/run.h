#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "collision_forge/base/files/resumable_file.h"

namespace forge {

/// Work over many items whose results go to a file, item by item. A run that was stopped goes on
/// when it is started again with the same options, and refuses with others.
struct Run {
  std::string path;  ///< of the results; while they grow PATH.part, and PATH.options beside them
  /// Everything that the results depend on, but the program's version, which is compared, too.
  ResumableFile::Options options;
  ItemLayout layout;
  std::string items;      ///< what they are, for messages, as "requests"
  std::size_t count = 0;  ///< of the items
  int jobs = 1;           ///< threads, in every rank of mpirun

  /// An item's lines, without the last line end. Called on any thread of any rank; thread-safe, and
  /// the lines depend on the index and the options alone.
  std::function<std::string(std::size_t index)> work;
  /// Takes an item's lines on the master, in the items' order, those of a run before like new ones.
  /// Throws for lines that are not of that item; `where` says where they stand.
  std::function<void(std::size_t index, const std::string& where, const std::string& lines)> take;
};

/// Makes the results that are missing, with progress on stderr. On SIGINT, SIGTERM and SIGHUP it
/// tells what is kept and how to go on. Throws as ResumableFile and dispatch() do, and
/// std::runtime_error for a file with more items than there are. Every rank must call it; what is
/// taken, and the file, are the master's alone.
void carryOut(const Run& run);

/// The master's decision, on every rank: all call `decide`, which may call carryOut(). What it
/// throws on the master is thrown there; the others get nothing then.
std::optional<std::size_t> agree(const std::function<std::size_t()>& decide);

}  // namespace forge
