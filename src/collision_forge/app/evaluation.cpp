#include "collision_forge/app/evaluation.h"

#include <boost/timer/progress_display.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>

#include "collision_forge/batch/dispatch.h"

namespace forge {

std::string rowBytes(const std::vector<ResultRow>& rows) {
  std::string bytes;
  for (const ResultRow& row : rows) bytes += toCsv(row) + "\n";
  return bytes;
}

std::vector<ResultRow> runEvaluation(const std::string& folder, const ResultFile::Run& run,
                                     int jobs, const std::function<std::string(std::size_t)>& work,
                                     const std::function<void(const std::string&)>& take_rest) {
  std::unique_ptr<ResultFile> file;
  std::unique_ptr<boost::timer::progress_display> progress;
  std::size_t done = 0;
  if (isMaster()) {
    file = std::make_unique<ResultFile>(folder, run);
    file->open();
    done = file->itemsDone();
    progress = std::make_unique<boost::timer::progress_display>(run.items.size(), std::cerr);
    *progress += done;
  }
  const auto take = [&](std::size_t, const std::string& bytes) {
    std::vector<ResultRow> rows;
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);) {
      if (rows.size() < run.rows_per_item) {
        rows.push_back(rowFromCsv(line, run.protocol).value());
      } else {
        take_rest(line);
      }
    }
    file->add(rows);
    ++*progress;
  };
  dispatch(run.items.size(), work, take, {jobs, done});
  if (!file) return {};
  file->finish();
  return file->rows();
}

std::string reportTitle(const std::string& title, const StatisticsOptions& statistics) {
  return title + "; rates with " + std::to_string(std::lround(100.0 * statistics.confidence)) +
         " % intervals over scenes\n";
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
