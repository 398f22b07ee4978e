#include "collision_forge/base/scene/contact_conditions.h"

#include <algorithm>
#include <iterator>

namespace forge {

const RangeControl* rangeControl(const std::string& name) {
  const auto found =
      std::find_if(std::begin(kRangeControls), std::end(kRangeControls),
                   [&](const RangeControl& control) { return name == control.name; });
  return found != std::end(kRangeControls) ? found : nullptr;
}

std::string optionName(const std::string& control) {
  std::string name = control;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

bool asksForConditions(const CollisionRequest& request) {
  return request.from_side.has_value() || request.hidden_by.has_value() ||
         std::any_of(
             std::begin(kRangeControls), std::end(kRangeControls),
             [&](const RangeControl& control) { return (request.*control.asked).has_value(); });
}

}  // namespace forge
