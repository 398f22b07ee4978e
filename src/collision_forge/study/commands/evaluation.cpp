#include "collision_forge/study/commands/evaluation.h"

#include <cmath>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/run.h"

namespace forge {

std::vector<ResultRow> runEvaluation(const EvaluationRun& evaluation) {
  std::vector<ResultRow> rows;
  Run run;
  run.path = evaluation.folder + "/results.csv";
  run.options = evaluation.options;
  run.layout = {csvHeader(evaluation.protocol, evaluation.rows_of), evaluation.rows_per_item};
  run.items = evaluation.of;
  run.count = evaluation.items.size();
  run.jobs = evaluation.jobs;
  run.work = [&](std::size_t index) {
    std::string lines;
    for (const ResultRow& row : evaluation.rowsOf(index)) {
      lines += (lines.empty() ? "" : "\n") + toCsv(row);
    }
    return lines;
  };
  run.take = [&](std::size_t index, const std::string& where, const std::string& lines) {
    for (ResultRow& row :
         readResultRows(where, lines, evaluation.protocol, evaluation.items[index])) {
      rows.push_back(std::move(row));
    }
  };
  carryOut(run);
  return rows;
}

void writeRates(const std::vector<RateTable>& tables, const std::string& folder) {
  std::string csv = rateCsvHeader() + "\n";
  for (const RateTable& table : tables) csv += toCsv(table);
  writeText(folder + "/table.csv", csv);
}

}  // namespace forge
