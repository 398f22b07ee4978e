#pragma once

#include <functional>
#include <string>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Kinds of input files of forge report.
enum class ReportFileKind {
  kScenarios,     ///< output of forge generate, or the attempts of forge study dataset
  kPlannerTests,  ///< results.jsonl of forge test, train.jsonl and test.jsonl of forge tune
  kMaps,          ///< PNG pictures, normally map.png of forge sweep; shown as they are
};

/// An input file with its detected kind.
struct ReportFile {
  std::string path;     ///< as given by the user
  ReportFileKind kind;  ///< as detected by openReportFile()
};

/// Returns the file with its kind, which the ending ".png" (lower case) or else the key "format" of
/// the first line determines ("collision_forge/scenario" or "collision_forge/planner_test"). The
/// content of a PNG file is not checked. Throws std::runtime_error, naming file and line, if the
/// file cannot be read or is of no known kind (as an empty one), JsonLineError for a malformed
/// first line, and InputError as readInputLine().
ReportFile openReportFile(const std::string& path, const InputLimits& limits);

/// Receives one line of a file: `where` ("FILE: line 2", for messages), the line number from 1 on,
/// the text without its line end, and the share (0..1) of the file's bytes read so far.
using OnReportLine = std::function<void(const std::string& where, std::size_t line,
                                        const std::string& text, double share)>;
/// Calls `on_line` for each line of a file (of a kind other than kMaps), in order, on the calling
/// thread; never for an empty file. Throws std::runtime_error if the file cannot be read,
/// InputError as readInputLine(), and any exception of `on_line`.
void readReportLines(const ReportFile& file, const InputLimits& limits,
                     const OnReportLine& on_line);

/// Returns a percent-encoded URL of the file at `path`, relative to `folder`, where the page lies.
/// Relative arguments count from the working directory.
std::string linkTo(const std::string& path, const std::string& folder);

}  // namespace forge
