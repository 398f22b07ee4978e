#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "collision_forge/base/files/resumable_file.h"

namespace forge {

/// Work on many items whose results go to a file, item by item. An interrupted run resumes when
/// started again with the same options, and throws if they differ.
struct Run {
  std::string path;  ///< results file; until complete PATH.part, see ResumableFile
  /// All options on which the results depend. Only these and the program's version, which is added,
  /// are compared: a run may resume with other `jobs`.
  ResumableFile::Options options;
  ItemLayout layout;      ///< header and lines per item of the results file
  std::string items;      ///< name of the items in messages, as "requests"
  std::size_t count = 0;  ///< number of items
  int jobs = 1;           ///< number of threads, >= 1

  /// Returns an item's lines, without the last line end. Called once per missing item, on any
  /// thread; must be thread-safe and depend on the index and the options alone. An exception ends
  /// the run.
  std::function<std::string(std::size_t index)> work;
  /// Receives an item's lines, in order of index, on the thread of carryOut(), including the items
  /// of earlier runs; new items are written afterwards. Throws for lines that do not belong to the
  /// item; `where` gives their position.
  std::function<void(std::size_t index, const std::string& where, const std::string& lines)> take;
};

/// Computes the missing results and completes the file, with progress on stderr; does nothing more
/// if an earlier run completed it. On SIGINT, SIGTERM and SIGHUP prints what is kept and how to
/// continue. Throws as ResumableFile and dispatch(), and std::runtime_error for a file with more
/// items than `count`, or a completed one with fewer.
void carryOut(const Run& run);

}  // namespace forge
