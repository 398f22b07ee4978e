#include "collision_forge/planner_test/statistics/rate_table.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/csv_text.h"

namespace forge {
namespace {

template <typename Cell>
void writeRow(std::ostream& out, const std::string& title, const std::vector<Rate>& rates,
              Cell cell_text) {
  out << "| " << title << " |";
  for (const Rate& rate : rates) out << ' ' << cell_text(rate) << " |";
  out << '\n';
}

bool sameTrials(const std::vector<Rate>& a, const std::vector<Rate>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Rate& x, const Rate& y) { return x.trials == y.trials; });
}

}  // namespace

RateTable tabulateTrials(const Measure& measure, const MethodTrials& trials) {
  RateTable table{measure, {}, {}, {}};
  std::vector<Trial> of_all;
  for (const auto& [method, of_method] : trials) {
    of_all.insert(of_all.end(), of_method.begin(), of_method.end());
  }
  for (const TrialGroup& group : groupTrials(of_all)) table.groups.push_back(group.title);
  for (const auto& [method, of_method] : trials) {
    const std::vector<TrialGroup> groups = groupTrials(of_method);
    table.methods.push_back(method);
    table.rates.emplace_back();
    for (const std::string& title : table.groups) {
      // A method without trials of an additional type has no group of this type.
      const auto group = std::find_if(groups.begin(), groups.end(),
                                      [&](const TrialGroup& own) { return own.title == title; });
      table.rates.back().push_back(
          pooledRate(group != groups.end() ? group->trials : std::vector<Trial>()));
    }
  }
  return table;
}

std::string toText(const Rate& rate, double scale) {
  if (rate.trials == 0) return "-";
  const std::string value = formatted("%.1f", scale * rate.value);
  if (!rate.interval) return value;
  return value +
         formatted(" [%.0f, %.0f]", scale * rate.interval->low, scale * rate.interval->high);
}

std::string intervalCsv(const Rate& rate) {
  if (!rate.interval) return ",";
  return formatted("%.4f,%.4f", rate.interval->low, rate.interval->high);
}

std::string toMarkdown(const RateTable& table, const TableUnit& unit) {
  std::ostringstream out;
  out << table.measure.title << ", " << unit.name << "\n\n| method |";
  for (const std::string& group : table.groups) out << ' ' << group << " |";
  out << "\n|---|";
  for (std::size_t i = 0; i < table.groups.size(); ++i) out << "---|";
  out << '\n';
  const auto count = [](const Rate& rate) { return std::to_string(rate.trials); };
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    writeRow(out, table.methods[i], table.rates[i],
             [&](const Rate& rate) { return toText(rate, unit.scale); });
  }
  const bool same = std::all_of(table.rates.begin(), table.rates.end(), [&](const auto& rates) {
    return sameTrials(rates, table.rates.front());
  });
  for (std::size_t i = 0;
       i < (same ? std::min<std::size_t>(1, table.methods.size()) : table.methods.size()); ++i) {
    writeRow(out, same ? "of" : "of, " + table.methods[i], table.rates[i], count);
  }
  return out.str();
}

std::string rateCsvHeader() { return "measure,method,group,trials,value,low,high"; }

std::string toCsv(const RateTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    for (std::size_t group = 0; group < table.groups.size(); ++group) {
      const Rate& rate = table.rates[i][group];
      const std::string value = rate.trials > 0 ? formatted("%.4f", rate.value) : "";
      text += table.measure.name + ',' + csvText(table.methods[i]) + ',' + table.groups[group] +
              ',' + std::to_string(rate.trials) + ',' + value + ',' + intervalCsv(rate) + '\n';
    }
  }
  return text;
}

std::string reportTitle(const std::string& title) {
  return title + "; rates with " +
         std::to_string(std::lround(100.0 * StatisticsOptions().confidence)) +
         " % intervals over scenes, none below " + std::to_string(kMinScenes) + " scenes\n";
}

}  // namespace forge
