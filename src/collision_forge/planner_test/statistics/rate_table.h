#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"

namespace forge {

/// A criterion that an attack meets or not, or a value of the attack. Tables show its rate, or its
/// mean.
struct Measure {
  std::string name;   ///< column name in results.csv
  std::string title;  ///< shown above the table
  std::optional<std::size_t>
      given;  ///< index of another measure; the rate is among rows that meet it; empty: all rows
};

/// Rates of one measure: one row per method, one column per group (groupTrials()).
struct RateTable {
  Measure measure;
  std::vector<std::string> methods;      ///< titles of the rows
  std::vector<std::string> groups;       ///< titles of the columns
  std::vector<std::vector<Rate>> rates;  ///< by method, then by group
};

/// Trials of a table: one element per row, in order, with its method.
using MethodTrials = std::vector<std::pair<std::string, std::vector<Trial>>>;

/// Computes the rates with intervals (pooledRate()) for each method and group.
RateTable tabulateTrials(const Measure& measure, const MethodTrials& trials);

/// Unit in which a table shows its values.
struct TableUnit {
  const char* name = "%";  ///< shown in the title
  double scale = 100.0;    ///< factor from the value to the shown number
};

/// Returns e.g. "81.2 [78, 84]", "81.2" without an interval, "-" without trials.
std::string toText(const Rate& rate, double scale);

/// Returns the ends of the interval as CSV, e.g. "0.7760,0.8440"; "," without an interval.
std::string intervalCsv(const Rate& rate);

/// Returns the table as Markdown: title, cells of toText() in the unit, and a last row with the
/// number of trials (per method if they differ).
std::string toMarkdown(const RateTable& table, const TableUnit& unit = {});

/// Returns "measure,method,group,trials,value,low,high", without a line end.
std::string rateCsvHeader();
/// Returns one line per method and group, each with a line end; values unscaled, empty without
/// trials.
std::string toCsv(const RateTable& table);

/// Returns the first line of a report with rates, which names the confidence level.
std::string reportTitle(const std::string& title);

}  // namespace forge
