#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"

namespace forge {

/// A criterion that an attack or a rollout meets or not, or a value of it. Tables show the rate of
/// the criterion, or the mean of the value.
struct Measure {
  std::string name;   ///< short name, a column of results.csv or of a CSV of toCsv()
  std::string title;  ///< for people, without the unit; shown above the table
  /// Index of another measure in the caller's list of measures: only rows that meet that measure
  /// are trials; empty: all rows. The functions of this file ignore it.
  std::optional<std::size_t> given;
};

/// Rates of one measure: one row per method (or planner, or other subject), one column per group of
/// trials (groupTrials()).
struct RateTable {
  Measure measure;                       ///< criterion or value that all rates are about
  std::vector<std::string> methods;      ///< titles of the rows
  std::vector<std::string> groups;       ///< titles of the columns
  std::vector<std::vector<Rate>> rates;  ///< rates[i][k]: of methods[i] and groups[k]
};

/// Trials of a table: one element per row, in the order of the rows: the row's title and its
/// trials.
using MethodTrials = std::vector<std::pair<std::string, std::vector<Trial>>>;

/// Groups the trials of each row with groupTrials() and returns the pooledRate() of each group,
/// with the default StatisticsOptions. The columns are the groups of the trials of all rows
/// together; a row without trials in a column has Rate() there. Without rows, the table has the
/// columns of groupTrials({}) and no rows.
RateTable tabulateTrials(const Measure& measure, const MethodTrials& trials);

/// Unit in which a table shows its values.
struct TableUnit {
  const char* name = "%";  ///< shown in the title
  double scale = 100.0;    ///< factor from the value to the shown number
};

/// Returns the rate times `scale` with one decimal and its interval without decimals, e.g. "81.2
/// [78, 84]"; "81.2" without an interval, "-" without trials.
std::string toText(const Rate& rate, double scale);

/// Returns the ends of the interval as two CSV fields, unscaled with four decimals, e.g.
/// "0.7760,0.8440"; "," without an interval.
std::string intervalCsv(const Rate& rate);

/// Returns the table as Markdown: a line "TITLE, UNIT", cells of toText() in the unit, and a last
/// row "of" with the number of trials (if the methods differ in it, one row "of, METHOD" for each).
/// A table without methods has the title and the column titles only.
std::string toMarkdown(const RateTable& table, const TableUnit& unit = {});

/// Returns "measure,method,group,trials,value,low,high", without a line end.
std::string rateCsvHeader();
/// Returns one line per method and group, in this order, in the columns of rateCsvHeader(), each
/// with a line end: Measure::name, title of the method (csvText()), title of the group, number of
/// trials, value (unscaled with four decimals, empty without trials) and intervalCsv().
std::string toCsv(const RateTable& table);

/// Returns the first line of a report with rates: `title`, the default
/// StatisticsOptions::confidence and kMinScenes; with a line end.
std::string reportTitle(const std::string& title);

}  // namespace forge
