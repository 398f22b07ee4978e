#include "collision_forge/study/evaluation/row_rates.h"

namespace forge {

std::vector<Trial> trialsOf(const std::vector<ResultRow>& rows, const std::string& method,
                            std::size_t measure, const std::optional<std::size_t>& given) {
  std::vector<Trial> trials;
  for (const ResultRow& row : rows) {
    if (row.method != method || (given && !row.meets[*given])) continue;
    trials.push_back({row.scene, row.type, row.tta, row.meets[measure] ? 1.0 : 0.0});
  }
  return trials;
}

std::vector<RateTable> tabulate(const std::vector<ResultRow>& rows, Protocol protocol,
                                const std::vector<std::string>& methods) {
  std::vector<RateTable> tables;
  const std::vector<Measure>& measures = measuresOf(protocol);
  for (std::size_t measure = 0; measure < measures.size(); ++measure) {
    MethodTrials trials;
    for (const std::string& method : methods) {
      trials.emplace_back(method, trialsOf(rows, method, measure, measures[measure].given));
    }
    tables.push_back(tabulateTrials(measures[measure], trials));
  }
  return tables;
}

}  // namespace forge
