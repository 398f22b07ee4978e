#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/planner_test/report/report_row.h"

namespace forge {

/// The files that forge report reads.
enum class ReportFileKind {
  kScenarios,     ///< of forge generate, or the attempts of forge study dataset
  kPlannerTests,  ///< results.jsonl of forge test, train.jsonl and test.jsonl of forge tune
  kRows,          ///< of a RowFormat, as results.csv of forge study evaluate
};

/// A file with a row of the page's table in every line. Programs above this module add formats.
struct RowFormat {
  std::string header;  ///< the first line of such a file, by which it is recognised
  /// The row of a line after the header; empty for a line that is no row.
  std::function<std::optional<ReportRow>(const std::string& line)> rowOf;
};

struct ReportFile {
  std::string path;
  ReportFileKind kind;
  RowFormat format = {};  ///< with kRows
};

/// Tells by its first line what a file holds. Throws std::runtime_error, naming file and line, for
/// one that cannot be read or is none of these, InputError as readInputLine().
ReportFile openReportFile(const std::string& path, const std::vector<RowFormat>& formats,
                          const InputLimits& limits);

/// Hands over the lines of a file, the header of a RowFormat left out: where it stands ("FILE: line
/// 2"), the number from 1 on, the text, and the share of the file that has been read. Throws as
/// readInputLine().
using OnReportLine = std::function<void(const std::string& where, std::size_t line,
                                        const std::string& text, double share)>;
void readReportLines(const ReportFile& file, const InputLimits& limits,
                     const OnReportLine& on_line);

/// Where a page in `folder` finds a file: a path relative to it, written as a link.
std::string linkTo(const std::string& path, const std::string& folder);

}  // namespace forge
