#pragma once

#include <string>
#include <utility>
#include <vector>

#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/study/evaluation/control_evaluation.h"

namespace forge {

using AnsweredQuestion = std::pair<ControlQuestion, ControlAnswer>;

/// How one value of a control fared.
struct ControlRates {
  std::string control;
  std::string value;
  int asked = 0;
  int declined = 0;  ///< for the road (kRoadDoesNotAllow): no control is the reason
  Rate answered;     ///< of the others
  Rate kept;         ///< of what was answered
  std::vector<Rate> answered_by_type;  ///< as `answered`, in the order of kCollisionTypes
};

/// One each value, in the order in which they are first asked for, those of a control together.
std::vector<ControlRates> controlRates(const std::vector<AnsweredQuestion>& questions);

/// A row a value: how often it was asked, declined for the road, answered and kept, and the share
/// answered by type.
std::string toMarkdown(const std::vector<ControlRates>& rates);

/// "control,value,type,trials,answered,low,high,kept", a line a value and type, and one of all
/// types, which alone has an interval and what was kept. Trials are what was not declined for the
/// road. Each with its end; shares in [0, 1], empty without trials.
std::string toCsv(const std::vector<ControlRates>& rates);

}  // namespace forge
