#pragma once

#include <vector>

#include "collision_forge/planners/pdm_map.h"
#include "collision_forge/planners/pdm_path.h"
#include "parity/parity_fixture.h"

namespace forge {

/// A map of maps.json.
class ParityMap {
 public:
  ParityMap(const ParityFixture& maps, const std::string& name);
  /// With the lanes of all roads of the route named as on it.
  PdmMap pdmMap(const std::string& route) const;
  /// The nodes of lanes that follow each other.
  PdmPath pathAlong(const rapidjson::Value& lanes) const;
  /// Of a lane; the fallback where it has none.
  double speedLimit(const std::string& lane, double fallback) const;
  const rapidjson::Value& value() const { return map_; }

 private:
  const rapidjson::Value& map_;
};

std::vector<Vector2> outlineOf(const rapidjson::Value& points);

}  // namespace forge
