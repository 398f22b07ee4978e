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

/// What evaluate does, in both its forms: over clips of COLLIDE and over requests on logs.
namespace forge {

struct EvaluationArguments {
  std::string collide;  ///< these four of clips
  std::string split = "val";
  bool by_scene = false;
  std::size_t limit = 0;
  std::string requests;  ///< these two of requests
  std::vector<std::string> scenes;
  LogSource logs;  ///< of clips the maps of a nuScenes root
  std::string out;
  std::string report;  ///< folder of the page of forge report; empty: none
  ConfigFolder config;
  EvaluationPlan plan;             ///< its limits and `believable` are those below
  std::optional<LimitSet> limits;  ///< these two of requests, by default those of the configuration
  std::optional<bool> believable;
  int jobs = 1;
};

// Both print tables and write OUT/results.csv, OUT/table.md, OUT/table.csv and charts, of
// requests also OUT/motion.csv, OUT/scorecard.md and OUT/scorecard.csv, on the master alone, and
// return an exit code. They go on with the results of an interrupted run.
int evaluateClips(const EvaluationArguments& arguments);
int evaluateRequests(const EvaluationArguments& arguments);

/// Items that give as many rows each.
struct EvaluationRun {
  std::string folder;  ///< of results.csv; is there
  ResumableFile::Options options;
  Protocol protocol = Protocol::kStrict;
  RowsOf rows_of = RowsOf::kClips;
  std::string of;                  ///< what the items are, as "clips"
  std::vector<std::string> items;  ///< their names, which the rows bear
  std::size_t rows_per_item = 1;
  int jobs = 1;
  std::function<std::vector<ResultRow>(std::size_t index)> rowsOf;
};

/// The rows of all items, on the master; none elsewhere. Throws as carryOut().
std::vector<ResultRow> runEvaluation(const EvaluationRun& evaluation);

/// Writes the tables to OUT/table.csv, and returns the arguments of charts.py that draw its
/// headline measures; `title` says what was measured.
std::vector<std::string> writeRates(const std::vector<RateTable>& tables, const std::string& title,
                                    const std::string& folder);

}  // namespace forge
