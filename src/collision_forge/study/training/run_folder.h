#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/study/training/training_run.h"

/// Helpers of all trainings: the run folder, which can only be resumed with unchanged inputs, the
/// validation split, and the table of metrics.
namespace forge {

/// Returns the names of the scenes that the training must not use, the scenes of run.fold
/// (scenesOfFold()); empty for fold 0. Throws std::runtime_error for a fold without scenes.
std::set<std::string> leftOutScenes(const TrainingRun& run);

/// Returns the text of run.txt: lines "name = value" with program version, clips, splits, logs
/// (fingerprints), fold, folds, seed, device and run.config_files; then the content of the
/// configuration file `config` (path relative to config/, "study/training.yaml"). Leaves out the
/// fields `out`, `threads`, `stop_after`, `sources.jobs` and `generator` of the run;
/// trainGenerator() puts the name of the generator before the text.
std::string describeRun(const TrainingRun& run, const std::string& config);

/// Creates the run folder run.out with run.txt, or checks that the existing run.txt equals
/// `description`. Returns the lock of the folder, to be held during the training. Throws
/// std::runtime_error naming the first different line, or if a state exists without run.txt, and
/// the exceptions of OutputLock.
[[nodiscard]] OutputLock openRunFolder(const TrainingRun& run, const std::string& description);

/// Returns the content of a file, byte for byte, or "" if it cannot be read.
std::string readText(const std::string& path);

/// Returns the path of the training state, OUT/state.pt.
std::string statePath(const TrainingRun& run);

/// Returns true if the training state exists. Throws std::runtime_error if its checksum is not one
/// that EpochTable::keep() wrote.
bool hasState(const TrainingRun& run);

/// Indices of samples, ascending; each sample is in one of the two.
struct SampleSplit {
  std::vector<std::size_t> training;    ///< for the training itself
  std::vector<std::size_t> validation;  ///< for the choice of the best epoch
};

/// Splits samples so that both parts share no scene. `scenes` holds the name of the scene of each
/// sample. One of n equal parts of the scenes (rounded up), chosen by `seed`, is for validation: n
/// is 1 / `validation_share`, rounded, at least 2; none for the share 0.
SampleSplit splitByScene(const std::vector<std::string>& scenes, double validation_share,
                         std::uint64_t seed);

/// Checksums, fingerprint(), of the files after one epoch.
struct EpochSums {
  std::string state;  ///< of the training state
  std::string rows;   ///< of the rows of metrics.csv up to this epoch
};

/// metrics.csv of a run folder: the header "epoch" and `columns`, then one row per epoch (from 1)
/// with six decimals. The best epoch has the lowest last column, as written; the first of equals.
class EpochTable {
 public:
  /// `columns`: names of the columns after "epoch". Reads the first `epochs` rows of
  /// OUT/metrics.csv, the epochs of the training state (0: reads nothing); the next add() drops
  /// later rows. Throws std::runtime_error naming file and line if a row is missing or damaged.
  EpochTable(const TrainingRun& run, const std::vector<std::string>& columns, int epochs);

  /// Appends a row with the next epoch and `numbers`, one per column, and rewrites the file.
  /// Returns true if the last number is lower than in all rows before: the epoch is the best so
  /// far. Throws std::runtime_error if the file cannot be written.
  bool add(const std::vector<double>& numbers);

  /// Writes the training state `state` (the content of the file) that belongs to the last row; must
  /// be called once per add(). Writes the checksums before the state and keeps older ones, so that
  /// the existing state has a checksum whenever the process is killed.
  void keep(const std::string& state);

  /// Returns the row added last, without line end. add() must have been called.
  const std::string& lastRow() const { return rows_.back(); }

 private:
  /// Returns the first line of the file.
  std::string header() const;
  /// Appends a row to rows_ only. Throws std::runtime_error for a malformed row.
  void append(const std::string& row);

  std::string path_;
  std::string state_path_;
  std::vector<std::string> columns_;
  std::vector<std::string> rows_;
  std::string rows_sum_;
  std::vector<EpochSums> sums_;
  double best_;
};

}  // namespace forge
