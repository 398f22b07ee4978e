#include <gtest/gtest.h>

#include <map>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/io/logs/nuscenes_tables.h"

namespace forge {
namespace {

TEST(NuScenesEmbedded, everySceneAndItsMapAreRead) {
  const std::string dataroot = std::string(COLLISION_FORGE_SOURCE_DIR) + "/data/embedded";
  const NuScenesRoot root(dataroot, "v1.0-embedded");
  ASSERT_FALSE(root.sceneNames().empty());
  std::map<std::string, std::shared_ptr<const LaneMap>> maps;
  for (const std::string& name : root.sceneNames()) {
    SCOPED_TRACE(name);
    const NuScenesRecording recording = root.readScene(name);
    auto& map = maps[recording.location];
    if (!map) {
      map = std::make_shared<const LaneMap>(readNuScenesMap(
          dataroot, recording.location, DrivingSide::kRight, {1.0, shippedLimits()}));
    }
    const Scene scene = toScene(recording, {{4.084, 1.73}, 1.0}, map);
    EXPECT_FALSE(scene.map->lanes.empty());
    EXPECT_FALSE(scene.map->drivable_area.empty());
    EXPECT_GT(scene.frame_times.size(), 1U);
    EXPECT_GT(scene.ego.states.size(), 1U);
    EXPECT_FALSE(scene.agents.empty());
    std::vector<Vector2> ego_positions;
    for (const AgentState& state : scene.ego.states) {
      ego_positions.push_back(state.pose.position());
    }
    EXPECT_FALSE(cropped(*map, ego_positions, 50.0).lanes.empty()) << "the ego is off its map";
  }
}

}  // namespace
}  // namespace forge
