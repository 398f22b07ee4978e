#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Returns the rows of `method` as trials of the measure with index `measure` in measuresOf(),
/// value 1 if the row meets it, else 0, in the order of `rows`. With `given`, returns only the rows
/// that meet the measure with index `given`.
std::vector<Trial> trialsOf(const std::vector<ResultRow>& rows, const std::string& method,
                            std::size_t measure, const std::optional<std::size_t>& given = {});

/// Returns one table per measure of measuresOf(protocol), in that order, with the rates of the
/// given methods as rows, in the order of `methods`; a rate counts only rows that meet the measure
/// Measure::given, if that is set. Ignores rows of other methods.
std::vector<RateTable> tabulate(const std::vector<ResultRow>& rows, Protocol protocol,
                                const std::vector<std::string>& methods);

}  // namespace forge
