#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// The rows of one method as trials of the measure at an index; all, or those that meet `given`.
std::vector<Trial> trialsOf(const std::vector<ResultRow>& rows, const std::string& method,
                            std::size_t measure, const std::optional<std::size_t>& given = {});

/// One table a measure of the protocol. Methods in the order given; rows of others are left out.
std::vector<RateTable> tabulate(const std::vector<ResultRow>& rows, Protocol protocol,
                                const std::vector<std::string>& methods);

}  // namespace forge
