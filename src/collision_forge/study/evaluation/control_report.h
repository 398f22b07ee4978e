#pragma once

#include <string>
#include <utility>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/evaluation/control_evaluation.h"

namespace forge {

using AnsweredQuestion = std::pair<ControlQuestion, ControlAnswer>;

/// The success rates of one value of a control.
struct ControlRates {
  std::string control;
  std::string value;
  int asked = 0;      ///< requests
  int rejection = 0;  ///< requests that the road does not allow (kRoadDoesNotAllow)
  Rate answered;      ///< solved requests, among the requests that the road allows
  Rate kept;          ///< attacks that meet the control, of the solved requests
  std::vector<Rate> answered_by_type;  ///< as `answered`, in the order of kCollisionTypes
};

/// Returns the rates of each value, grouped by control, in the order of first occurrence.
std::vector<ControlRates> controlRates(const std::vector<AnsweredQuestion>& questions);

/// Returns a Markdown table with one row per value: the counts, the rates in percent, and the share
/// of solved requests by type.
std::string toMarkdown(const std::vector<ControlRates>& rates);

/// Returns CSV with the header "control,value,type,trials,answered,low,high,kept" and, for each
/// value, one line for all types and one per type; only the first has the interval (low, high) and
/// `kept`. `trials` counts the requests that the road allows. Shares are in 0..1, empty without
/// trials.
std::string toCsv(const std::vector<ControlRates>& rates);

}  // namespace forge
