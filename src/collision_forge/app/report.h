#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "collision_forge/planner_test/report/write_report.h"
#include "collision_forge/planner_test/settings/config.h"

/// The HTML report, for forge report and for commands with the option --report.
namespace forge {

/// Writes FOLDER/index.html (writeReportPage()) and prints its number of table rows (ReportRow: one
/// per attack, alternative, rejected request, planner's test and untested case) on stdout; without
/// rows the page is written, too. `inputs`: the files to show; `config`: settings and colours,
/// catalogues and limits. Locks nothing. Throws as writeReportPage() and readCatalogue().
void writeReport(const ReportInputs& inputs, const std::string& folder, const Config& config);

/// Adds --report, the folder of the HTML report, and returns this option; `folder` keeps its value
/// if the option is not given.
CLI::Option* addReportOption(CLI::App& app, std::string& folder);

}  // namespace forge
