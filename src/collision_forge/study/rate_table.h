#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/study/options.h"
#include "collision_forge/study/result_row.h"
#include "collision_forge/study/statistics.h"

namespace forge {

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
RateTable tabulateTrials(const Measure& measure, const MethodTrials& trials,
                         const StatisticsOptions& options);

/// The rows of one method as trials of the measure at an index; all, or those that meet `given`.
std::vector<Trial> trialsOf(const std::vector<ResultRow>& rows, const std::string& method,
                            std::size_t measure, const std::optional<std::size_t>& given = {});

/// One table a measure of the protocol. Methods in the order given; rows of others are left out.
std::vector<RateTable> tabulate(const std::vector<ResultRow>& rows, Protocol protocol,
                                const std::vector<std::string>& methods,
                                const StatisticsOptions& options);

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

}  // namespace forge
