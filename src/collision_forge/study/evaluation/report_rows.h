#pragma once

#include <vector>

#include "collision_forge/planner_test/report/report_files.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// The row of forge report for a row of results.csv of forge study evaluate.
ReportRow rowOfResult(const ResultRow& result);

/// The files results.csv of forge study evaluate that forge report reads: those of requests and
/// those of clips by the strict protocol.
std::vector<RowFormat> evaluationFormats();

}  // namespace forge
