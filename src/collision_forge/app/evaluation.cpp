#include "collision_forge/app/evaluation.h"

#include <cmath>
#include <utility>

#include "collision_forge/batch/run.h"

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

std::string reportTitle(const std::string& title, const StatisticsOptions& statistics) {
  return title + "; rates with " + std::to_string(std::lround(100.0 * statistics.confidence)) +
         " % intervals over scenes, none below " + std::to_string(kMinScenes) + " scenes\n";
}

Bar barOf(const Rate& rate) {
  const Interval interval = rate.interval.value_or(Interval{rate.value, rate.value});
  return {rate.value, interval.low, interval.high};
}

void drawTable(const RateTable& table, const std::string& title, const std::string& folder,
               const DrawingOptions& drawing) {
  const std::vector<Color> colors = {drawing.agent_color, drawing.pattern_ego_color,
                                     drawing.pattern_attacker_color, drawing.ego_color};
  BarChart chart{table.measure.title + ": " + title, table.groups, {}};
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    BarSeries series{table.methods[i], colors[i % colors.size()], {}};
    for (const Rate& rate : table.rates[i]) {
      series.bars.push_back(rate.trials > 0 ? std::optional<Bar>(barOf(rate)) : std::nullopt);
    }
    chart.series.push_back(std::move(series));
  }
  drawBarChart(folder + "/" + table.measure.name + ".png", chart, drawing);
}

}  // namespace forge
