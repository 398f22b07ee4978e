#pragma once

#include <vector>

#include "collision_forge/planner_test/report/report_files.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Converts a row of results.csv of forge study evaluate to a row of the HTML report.
ReportRow rowOfResult(const ResultRow& result);

/// Returns the formats of results.csv that the HTML report reads: requests, and clips by the strict
/// protocol.
std::vector<RowFormat> evaluationFormats();

}  // namespace forge
