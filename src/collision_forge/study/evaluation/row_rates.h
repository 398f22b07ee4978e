#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Returns the rows of `method` as trials of the measure with index `measure`. With `given`, only
/// rows that meet the measure with that index.
std::vector<Trial> trialsOf(const std::vector<ResultRow>& rows, const std::string& method,
                            std::size_t measure, const std::optional<std::size_t>& given = {});

/// Returns one table per measure of the protocol, with the given methods in this order. Ignores
/// rows of other methods.
std::vector<RateTable> tabulate(const std::vector<ResultRow>& rows, Protocol protocol,
                                const std::vector<std::string>& methods);

}  // namespace forge
