#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/study/training/training_run.h"

/// What trainings have in common: the folder of a run, that goes on only as the same run; who tells
/// the best epoch; a table of what every epoch gave, and its curves.
namespace forge {

/// What a run was asked for and by which version of the program, `config` being the file of config/
/// that it is trained by.
std::string describeRun(const TrainingRun& run, int ranks, const std::string& config);

/// Makes the run folder, or checks that the one there is of the same run; it is the caller's alone
/// while the lock lives. Throws std::runtime_error naming what differs, for a state without its
/// description, and as OutputLock does.
[[nodiscard]] OutputLock openRunFolder(const TrainingRun& run, const std::string& description);

/// All of a file; empty where it cannot be read.
std::string readText(const std::string& path);

/// File of what going on takes.
std::string statePath(const TrainingRun& run);

/// Whether there is one. Throws std::runtime_error naming a file that is not as EpochTable::keep()
/// wrote it.
bool hasState(const TrainingRun& run);

/// Indices of samples.
struct SampleSplit {
  std::vector<std::size_t> training;
  std::vector<std::size_t>
      validation;  ///< those of a share of the scenes; they tell the best epoch
};

/// `scenes` holds each sample's.
SampleSplit splitByScene(const std::vector<std::string>& scenes, double validation_share,
                         std::uint64_t seed);

/// Checksums of what going on after an epoch takes.
struct EpochSums {
  std::string state;
  std::string rows;  ///< of the table up to the epoch's
};

/// metrics.csv of a run folder: rows of numbers, one an epoch; the last column chooses the best
/// epoch.
class EpochTable {
 public:
  /// Of the file the first `epochs` rows are kept. Throws std::runtime_error naming file, line and
  /// what is wrong there, where one is damaged or missing.
  EpochTable(const TrainingRun& run, const std::vector<std::string>& columns, int epochs);

  /// Adds a row and writes the file anew. True where the last number is less than in every row
  /// before.
  bool add(const std::vector<double>& numbers);

  /// Writes what going on after the row that was added last takes; once a row. The checksums come
  /// first, to those of the epochs before, so that the state that is there always has its own,
  /// whenever the process is killed.
  void keep(const std::string& state);

  const std::string& lastRow() const { return rows_.back(); }

 private:
  std::string header() const;
  void append(const std::string& row);

  std::string path_;
  std::string state_path_;
  std::vector<std::string> columns_;
  std::vector<std::string> rows_;
  std::string rows_sum_;
  std::vector<EpochSums> sums_;
  double best_;
};

/// Draws columns of the run's metrics.csv as curves.png, by charts.py of the study. Throws as
/// runStudyProgram().
void drawCurves(const TrainingRun& run, const std::string& title,
                const std::vector<std::string>& columns);

}  // namespace forge
