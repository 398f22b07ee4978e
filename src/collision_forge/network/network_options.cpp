#include "collision_forge/network/network_options.h"

#include <stdexcept>

namespace forge {

const char* toString(EgoHead head) {
  switch (head) {
    case EgoHead::kRegionProposal:
      return "region_proposal";
    case EgoHead::kTargetPoints:
      return "target_points";
    case EgoHead::kRegression:
      return "regression";
  }
  return "unknown";
}

EgoHead egoHeadFromString(const std::string& name) {
  for (const EgoHead head :
       {EgoHead::kRegionProposal, EgoHead::kTargetPoints, EgoHead::kRegression}) {
    if (name == toString(head)) return head;
  }
  throw std::invalid_argument("head = " + name +
                              " is none of region_proposal, target_points, regression");
}

}  // namespace forge
