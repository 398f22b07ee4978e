#pragma once

#include <functional>
#include <string>

#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Kinds of input files of forge report.
enum class ReportFileKind {
  kScenarios,     ///< output of forge generate, or the attempts of forge study dataset
  kPlannerTests,  ///< results.jsonl of forge test, train.jsonl and test.jsonl of forge tune
  kMaps,          ///< map.png of forge sweep
};

/// An input file with its detected kind.
struct ReportFile {
  std::string path;
  ReportFileKind kind;
};

/// Detects the kind of a file by its first line, of a picture by its ending .png. Throws
/// std::runtime_error, naming file and line, if it cannot be read or is of no known kind,
/// InputError as readInputLine().
ReportFile openReportFile(const std::string& path, const InputLimits& limits);

/// Receives one line: `where` ("FILE: line 2"), the line number from 1 on, the text, and the share
/// (0..1) of the file read so far.
using OnReportLine = std::function<void(const std::string& where, std::size_t line,
                                        const std::string& text, double share)>;
/// Calls `on_line` for each line of a file. Throws as readInputLine().
void readReportLines(const ReportFile& file, const InputLimits& limits,
                     const OnReportLine& on_line);

/// Returns the relative URL of the file at `path` for a page in `folder`.
std::string linkTo(const std::string& path, const std::string& folder);

}  // namespace forge
