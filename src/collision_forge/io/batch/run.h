#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "collision_forge/base/files/resumable_file.h"

namespace forge {

/// Work on many items whose results go to a file, item by item. An interrupted run resumes when
/// started again with the same options, and throws if they differ.
struct Run {
  std::string path;  ///< results file; until complete PATH.part, see ResumableFile
  /// All options on which the results depend. The program's version is added and compared, too.
  ResumableFile::Options options;
  ItemLayout layout;
  std::string items;      ///< name of the items in messages, as "requests"
  std::size_t count = 0;  ///< number of items
  int jobs = 1;           ///< threads in every rank of mpirun

  /// Returns an item's lines, without the last line end. Called once per missing item, on any
  /// thread of any rank; must be thread-safe and depend on the index and the options alone. An
  /// exception ends the run.
  std::function<std::string(std::size_t index)> work;
  /// Receives an item's lines on the master, in order, including the items of earlier runs. Throws
  /// for lines that do not belong to the item; `where` gives their position.
  std::function<void(std::size_t index, const std::string& where, const std::string& lines)> take;
};

/// Computes the missing results, with progress on stderr. On SIGINT, SIGTERM and SIGHUP prints what
/// is kept and how to continue. Throws as ResumableFile and dispatch(), and std::runtime_error for
/// a file with more items than `count`. Every rank must call it; `take` and the file are used on
/// the master only.
void carryOut(const Run& run);

/// Runs `decide` on every rank (it may call carryOut()) and returns the master's result on all of
/// them. If `decide` throws on the master, the exception propagates there and the other ranks
/// return nullopt.
std::optional<std::size_t> agree(const std::function<std::size_t()>& decide);

}  // namespace forge
