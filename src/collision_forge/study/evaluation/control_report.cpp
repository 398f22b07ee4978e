#include "collision_forge/study/evaluation/control_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/rate_table.h"

namespace forge {
namespace {

struct ControlTrials {
  int asked = 0;
  std::vector<Trial> answered;
  std::vector<Trial> kept;
};

/// Returns the rate as "0.8125", or "" without trials.
std::string shareText(const Rate& rate) {
  return rate.trials > 0 ? formatted("%.4f", rate.value) : "";
}

long successes(const Rate& rate) { return std::lround(rate.value * rate.trials); }

Rate withoutInterval(Rate rate) {
  rate.interval.reset();
  return rate;
}

/// The order of the rows: values in order of first occurrence, grouped by control. Grouping is
/// needed because requests of different types have different manoeuvres.
class ControlOrder {
 public:
  void add(const ControlQuestion& question) {
    const std::pair<std::string, std::string> key{question.control, question.value};
    if (std::find(keys_.begin(), keys_.end(), key) != keys_.end()) return;
    const auto last = std::find_if(keys_.rbegin(), keys_.rend(), [&](const auto& known) {
      return known.first == question.control;
    });
    keys_.insert(last == keys_.rend() ? keys_.end() : last.base(), key);
  }
  const std::vector<std::pair<std::string, std::string>>& keys() const { return keys_; }

 private:
  std::vector<std::pair<std::string, std::string>> keys_;  // control, value
};

ControlRates ratesOf(const std::string& control, const std::string& value,
                     const ControlTrials& trials) {
  ControlRates rates;
  rates.control = control;
  rates.value = value;
  rates.asked = trials.asked;
  rates.declined = trials.asked - static_cast<int>(trials.answered.size());
  rates.answered = pooledRate(trials.answered);
  rates.kept = pooledRate(trials.kept);
  for (const CollisionType type : kCollisionTypes) {
    std::vector<Trial> of_type;
    std::copy_if(trials.answered.begin(), trials.answered.end(), std::back_inserter(of_type),
                 [type](const Trial& trial) { return trial.type == type; });
    rates.answered_by_type.push_back(pooledRate(of_type));
  }
  return rates;
}

}  // namespace

std::vector<ControlRates> controlRates(const std::vector<AnsweredQuestion>& questions) {
  ControlOrder order;
  std::map<std::pair<std::string, std::string>, ControlTrials> trials;
  for (const auto& [question, answer] : questions) {
    order.add(question);
    ControlTrials& of_value = trials[{question.control, question.value}];
    ++of_value.asked;
    if (answer.status == StatusCode::kRoadDoesNotAllow) continue;
    const bool is_answered = answer.status == StatusCode::kOk;
    const CollisionRequest& request = question.asked.request;
    Trial trial{question.asked.scene, request.type, request.tta, is_answered ? 1.0 : 0.0};
    of_value.answered.push_back(trial);
    if (!is_answered) continue;
    trial.value = answer.kept ? 1.0 : 0.0;
    of_value.kept.push_back(trial);
  }
  std::vector<ControlRates> rates;
  for (const auto& key : order.keys()) {
    rates.push_back(ratesOf(key.first, key.second, trials.at(key)));
  }
  return rates;
}

std::string toMarkdown(const std::vector<ControlRates>& rates) {
  std::ostringstream out;
  out << "| control | value | requests | not allowed by the road | solved | % of the others | "
         "constraint met |";
  for (const CollisionType type : kCollisionTypes) out << ' ' << toString(type) << ", % |";
  out << "\n|---|---|---|---|---|---|---|";
  for (std::size_t i = 0; i < std::size(kCollisionTypes); ++i) out << "---|";
  out << '\n';
  for (const ControlRates& row : rates) {
    const std::string kept = row.kept.trials > 0 ? formatted("%.2f", row.kept.value) : "-";
    out << "| " << row.control << " | " << row.value << " | " << row.asked << " | " << row.declined
        << " | " << successes(row.answered) << " | " << toText(row.answered, 100.0) << " | " << kept
        << " |";
    for (const Rate& of_type : row.answered_by_type) {
      out << ' ' << toText(withoutInterval(of_type), 100.0) << " |";
    }
    out << '\n';
  }
  return out.str();
}

std::string toCsv(const std::vector<ControlRates>& rates) {
  std::ostringstream out;
  out << "control,value,type,trials,answered,low,high,kept\n";
  for (const ControlRates& row : rates) {
    const std::string start = row.control + "," + row.value + ",";
    out << start << "all," << row.answered.trials << ',' << shareText(row.answered) << ','
        << intervalCsv(row.answered) << ',' << shareText(row.kept) << '\n';
    for (std::size_t i = 0; i < row.answered_by_type.size(); ++i) {
      const Rate& of_type = row.answered_by_type[i];
      out << start << toString(kCollisionTypes[i]) << ',' << of_type.trials << ','
          << shareText(of_type) << ",,,\n";
    }
  }
  return out.str();
}

}  // namespace forge
