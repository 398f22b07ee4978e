#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/drawing/bar_chart.h"
#include "collision_forge/drawing/options.h"
#include "collision_forge/study/clip_evaluation.h"
#include "collision_forge/study/rate_table.h"
#include "collision_forge/study/result_file.h"

/// What evaluate does, in both its forms: over clips of COLLIDE and over requests on logs.
namespace forge {

struct EvaluationArguments {
  std::string collide;  ///< these four of clips
  std::string split = "val";
  bool by_scene = false;
  std::size_t limit = 0;
  std::string requests;  ///< these three of requests
  std::string version;
  std::vector<std::string> scenes;
  std::string dataroot;
  std::string out;
  std::string config;
  EvaluationPlan plan;
  int jobs = 1;
};

// Both print tables and write OUT/results.csv, OUT/table.md and charts, on the master alone, and
// return an exit code. They go on with the results of an interrupted run.
int evaluateClips(const EvaluationArguments& arguments);
int evaluateRequests(const EvaluationArguments& arguments);

/// Evaluates the items that FOLDER/results.csv has no rows of yet, on all threads and ranks, and
/// returns all rows; none but on the master. `work(index)` gives an item's rows as rowBytes() has
/// them; lines after these go to `take_rest`. Throws as ResultFile and dispatch() do.
std::vector<ResultRow> runEvaluation(const std::string& folder, const ResultFile::Run& run,
                                     int jobs, const std::function<std::string(std::size_t)>& work,
                                     const std::function<void(const std::string&)>& take_rest = {});

/// Between processes an item's rows travel as lines.
std::string rowBytes(const std::vector<ResultRow>& rows);

/// The first line of a report.
std::string reportTitle(const std::string& title, const StatisticsOptions& statistics);

/// A rate in a chart; without an interval the whisker has no length.
Bar barOf(const Rate& rate);

/// A chart of a table as OUT/NAME.png; `title` says what was measured.
void drawTable(const RateTable& table, const std::string& title, const std::string& folder,
               const DrawingOptions& drawing);

}  // namespace forge
