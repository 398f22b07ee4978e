#pragma once

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/files/worker_process.h"

namespace forge {

/// A pickle that cannot be read. The message names the file and, where known, the field.
struct PickleError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value of Python: plain values as JSON, and beside them the items of NumPy's arrays.
struct PickleContent {
  /// An array is {"ndarray": SHAPE, "dtype": TYPE, "at": N}: its items are those from the Nth on,
  /// row by row.
  std::string json;
  /// 8 bytes each: of the types "f8" and "b1" (0 or 1) a double, of "i8" an std::int64_t.
  std::string items;
};

/// Processes of the program pickle_worker, which reads and writes pickles with Python. One is
/// started when none is idle, and a process that failed to answer is not asked again. May be used
/// from many threads.
class PickleWorkers {
 public:
  /// Reads "tracks", "map_features" and "metadata" of the scenario description in the file `path`.
  /// Nothing that the pickle names is run. Throws PickleError for a file that cannot be read, is no
  /// pickle of plain values and NumPy's arrays, or needs more than the limits in pickle_worker or a
  /// minute.
  PickleContent read(const std::string& path);
  /// Returns the bytes of the value's pickle (protocol 3). Arrays are float64, int64 and bool.
  std::string write(const PickleContent& content);
  /// Returns the bytes of the pickle of a dict: the name of each of `files`, a name and a path,
  /// with the "metadata" of the scenario description at the path. Throws as read().
  std::string summarize(const std::vector<std::pair<std::string, std::string>>& files);

 private:
  /// The text and the items of the answer.
  std::pair<std::string, std::string> ask(char request, const std::string& text,
                                          const std::string& items);
  std::unique_ptr<WorkerProcess> take();

  std::mutex mutex_;
  std::vector<std::unique_ptr<WorkerProcess>> idle_;
};

}  // namespace forge
