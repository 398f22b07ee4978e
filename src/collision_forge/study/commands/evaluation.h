#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"
#include "collision_forge/study/evaluation/result_row.h"

/// The command study evaluate in its two forms: over COLLIDE clips and over requests on logs.
namespace forge {

/// The arguments of the command.
struct EvaluationArguments {
  // Clips only:
  std::string collide;        ///< folder of the clips
  std::string split = "val";  ///< train, val or test
  bool by_scene = false;      ///< true: redistribute published train and val so that they share no
                              ///< scene (listCollideClipsByScene()); false: use them as published
  std::size_t limit = 0;      ///< number of clips, from the first on; 0: all
  // Requests only:
  std::string requests;  ///< path of the request list; empty: evaluate clips
  /// Names of the scenes whose requests are evaluated; empty: all.
  std::vector<std::string> scenes;
  std::optional<LimitSet> limits;  ///< of the attackers; empty: the configuration's
  std::optional<bool> believable;  ///< attackers must be plausible; empty: the configuration's

  LogSource logs;       ///< recorded scenes; for clips a nuScenes root with their maps
  std::string out;      ///< output folder
  ConfigFolder config;  ///< source of all options
  EvaluationPlan plan;  ///< evaluateRequests() replaces its limits and `believable`
  int jobs = 1;         ///< threads
};

// Run the evaluation; resume an interrupted one with the same inputs and options (`jobs` may
// differ). Print the tables and write OUT/results.csv (columns: result_row.h), OUT/table.md and
// OUT/table.csv (writeRates()). Return kExitOk; all failures, also of writing, throw: ConfigError,
// std::runtime_error, and std::invalid_argument for an unknown method.
/// Evaluates the clips of `split` in `collide`; ignores the fields for requests.
int evaluateClips(const EvaluationArguments& arguments);
/// Evaluates `requests`, which must not be empty; ignores the fields for clips.
int evaluateRequests(const EvaluationArguments& arguments);

/// An evaluation of items (clips or requests) that yield the same number of rows each.
struct EvaluationRun {
  std::string folder;                     ///< folder of results.csv; must exist
  ResumableFile::Options options;         ///< all inputs (fingerprints) and options on which
                                          ///< the rows depend; if results.csv was begun
                                          ///< with others, runEvaluation() throws
  Protocol protocol = Protocol::kStrict;  ///< determines the columns of results.csv
  RowsOf rows_of = RowsOf::kClips;        ///< determines the columns of results.csv
  std::string of;                         ///< plural noun for the items in messages, as "clips"
  std::vector<std::string> items;         ///< names of the items, the column `name` of their rows,
                                          ///< in the order of results.csv
  std::size_t rows_per_item = 1;          ///< number of rows that rowsOf() returns for each item
  int jobs = 1;                           ///< threads
  /// Returns the rows of items[index]; called from worker threads, once per item that no earlier
  /// run finished. An exception ends the run.
  std::function<std::vector<ResultRow>(std::size_t index)> rowsOf;
};

/// Runs the evaluation and writes results.csv; resumes an interrupted run. Returns all rows, in the
/// order of the items. Throws the exceptions of carryOut().
std::vector<ResultRow> runEvaluation(const EvaluationRun& evaluation);

/// Writes the rates of all tables (toCsv()), below one header (rateCsvHeader()), to
/// FOLDER/table.csv, replacing it; without tables, the header alone.
/// Throws std::runtime_error if the file cannot be written.
void writeRates(const std::vector<RateTable>& tables, const std::string& folder);

}  // namespace forge
