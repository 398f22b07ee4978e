#include "collision_forge/io/maps/driving_side.h"

namespace forge {

DrivingSide drivingSide(const DataOptions& options, const std::string& location,
                        const OppositeNeighbours& pairs, WarningCounter& warnings) {
  if (const auto side = configuredSide(options, location)) return *side;
  if (pairs.to_the_left == pairs.to_the_right) {
    warnings.add("maps without a driving side: right is assumed; set it in locations.yaml",
                 location);
  }
  return pairs.to_the_right > pairs.to_the_left ? DrivingSide::kLeft : DrivingSide::kRight;
}

}  // namespace forge
