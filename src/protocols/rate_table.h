#pragma once

#include <string>
#include <vector>

#include "formats/evaluation_options.h"
#include "protocols/result_row.h"
#include "protocols/statistics.h"

namespace forge {

/// The rates of one measure: a row a method, a column a group (groupTrials()).
struct RateTable {
  Measure measure;
  std::vector<std::string> methods;
  std::vector<std::string> groups;
  std::vector<std::vector<Rate>> rates;  ///< by method, then by group
};

/// One table a measure of the protocol. Methods in the order given; rows of others are left out.
std::vector<RateTable> tabulate(const std::vector<ResultRow>& rows, Protocol protocol,
                                const std::vector<std::string>& methods,
                                const StatisticsOptions& options);

/// As Markdown: title, then cells "81 [78, 84]" in percent, "-" without trials, and a last row with
/// the number of trials, by method where they differ.
std::string toMarkdown(const RateTable& table);

}  // namespace forge
