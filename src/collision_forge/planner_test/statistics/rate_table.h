#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"

namespace forge {

/// Something that one attack meets or does not, and that the tables have a rate of.
struct Measure {
  std::string name;  ///< column in results.csv
  std::string title;
  std::optional<std::size_t> given;  ///< rate among the rows that meet this measure; all if empty
  bool is_headline = false;          ///< drawn as a chart
};

/// The rates of one measure: a row a method, a column a group (groupTrials()).
struct RateTable {
  Measure measure;
  std::vector<std::string> methods;
  std::vector<std::string> groups;
  std::vector<std::vector<Rate>> rates;  ///< by method, then by group
};

/// The trials of a table: for each method, in this order, those of its row.
using MethodTrials = std::vector<std::pair<std::string, std::vector<Trial>>>;

/// The table of these trials.
RateTable tabulateTrials(const Measure& measure, const MethodTrials& trials);

/// What a table's values are shown in.
struct TableUnit {
  const char* name = "%";
  double scale = 100.0;  ///< shown for a value of 1
};

/// "81.2 [78, 84]", "81.2" without an interval, "-" without trials.
std::string toText(const Rate& rate, double scale);

/// The ends of the interval as CSV: "0.7760,0.8440", "," without one.
std::string intervalCsv(const Rate& rate);

/// As Markdown: title, then cells of toText() in the unit, and a last row with the
/// number of trials, by method where they differ.
std::string toMarkdown(const RateTable& table, const TableUnit& unit = {});

/// "measure,method,group,trials,value,low,high", without the line's end.
std::string rateCsvHeader();
/// A line a method and group, each with its end; values as they are, empty without trials.
std::string toCsv(const RateTable& table);

/// The first line of a report with rates.
std::string reportTitle(const std::string& title);

}  // namespace forge
