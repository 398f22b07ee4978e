#pragma once

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/files/worker_process.h"

namespace forge {

/// Thrown for a pickle that cannot be read. The message names the file and, if known, the field.
struct PickleError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A Python value: plain values as JSON, the items of NumPy arrays as bytes beside it.
struct PickleContent {
  /// An array is {"ndarray": SHAPE, "dtype": TYPE, "at": N}; its items start at item N of `items`,
  /// row by row.
  std::string json;
  /// 8 bytes per item: double for "f8" and "b1" (0 or 1), std::int64_t for "i8".
  std::string items;
};

/// A pool of pickle_worker processes, which read and write pickles with Python. The destructor ends
/// them. Starts a process if none is idle; never reuses a process that failed to respond.
/// Thread-safe.
class PickleWorkers {
 public:
  /// Reads "tracks", "map_features", "metadata" and "dynamic_map_states" of the scenario
  /// description in the file `path`; keys that the file lacks are absent in the result. A value
  /// that is neither plain nor a NumPy array becomes {"other": TYPE}. Never executes code named in
  /// the pickle. Throws PickleError if the file cannot be read, is no pickle of a dict with
  /// "metadata", exceeds the limits in pickle_worker, or takes over a minute, and if the process
  /// ends or cannot be started.
  PickleContent read(const std::string& path);
  /// Returns the value as a pickle (protocol 3), as bytes. Arrays are float64, int64 and bool.
  /// Throws PickleError for a content that is not valid, std::runtime_error if the process ends,
  /// cannot be started or takes over a minute.
  std::string write(const PickleContent& content);
  /// Returns a pickled dict, as bytes, that maps each name in `files` (pairs of name and path) to
  /// the "metadata" of the scenario description at its path. Throws PickleError for a file that
  /// cannot be read or is no pickle of a dict with "metadata", std::runtime_error as write().
  std::string summarize(const std::vector<std::pair<std::string, std::string>>& files);

 private:
  /// Sends one request to an idle process and returns the text and the items of the reply.
  /// `request`: 'r', 'w' or 's' for read(), write() and summarize(). Throws PickleError with the
  /// error in the reply.
  std::pair<std::string, std::string> ask(char request, const std::string& text,
                                          const std::string& items);
  /// Returns an idle process, or a new one.
  std::unique_ptr<WorkerProcess> take();

  std::mutex mutex_;
  std::vector<std::unique_ptr<WorkerProcess>> idle_;
};

}  // namespace forge
