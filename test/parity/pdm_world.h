#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/pdm_map.h"
#include "collision_forge/planner_test/planners/pdm_path.h"
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
  PdmPath pathAlong(const std::vector<std::string>& lanes) const;
  /// The lanes of the route from that nearest to the pose on.
  std::vector<std::string> lanesFrom(const Pose2& pose, const std::string& route) const;
  /// As a map of nuScenes has it, where there are no roads, but with the speed limits.
  std::shared_ptr<const LaneIndex> laneIndex() const;
  /// Of a lane; the fallback where it has none.
  double speedLimit(const std::string& lane, double fallback) const;

 private:
  const rapidjson::Value& lane(const std::string& name) const;
  bool isOnRoute(const std::string& lane, const std::string& route) const;

  const rapidjson::Value& map_;
};

std::vector<Vector2> outlineOf(const rapidjson::Value& points);

}  // namespace forge
