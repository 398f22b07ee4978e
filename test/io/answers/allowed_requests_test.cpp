#include "collision_forge/io/answers/allowed_requests.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

/// The ego drives along x on a road with two lanes in that direction, from 10 s before to 10 s
/// after t0.
IndexedScene onTwoLanes() {
  const auto map = twoLaneRoad();
  IndexedScene recording{{}, std::make_shared<const LaneIndex>(map)};
  recording.scene.ego = {kEgoId, AgentClass::kCar, kEgoSize, {}};
  for (int i = -20; i <= 20; ++i) {
    const double time = 0.5 * i;
    recording.scene.ego.states.push_back({kNow + time, {2.0 * time, 0.0, 0.0}, {2.0, 0.0}});
  }
  return recording;
}

bool isAllowed(CollisionType type, const IndexedScene& recording,
               const std::optional<AgentClass>& attacker_class = std::nullopt) {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  SceneRequest asked{"scene", kNow, {}};
  asked.request.type = type;
  asked.request.tta = 4.0;
  asked.request.attacker_class = attacker_class;
  return roadAllowsRequest(asked, recording, config);
}

TEST(AllowedRequests, RequireALaneOfTheTypesDirection) {
  const IndexedScene recording = onTwoLanes();
  EXPECT_TRUE(isAllowed(CollisionType::kRearEnd, recording));
  EXPECT_FALSE(isAllowed(CollisionType::kJunctionCrossing, recording));
}

TEST(AllowedRequests, NeedNoLaneForPeopleOnFoot) {
  const IndexedScene recording = onTwoLanes();
  const auto allows = [&](AgentClass agent_class) {
    return isAllowed(CollisionType::kJunctionCrossing, recording, agent_class);
  };
  EXPECT_TRUE(allows(AgentClass::kPedestrian));
  EXPECT_TRUE(allows(AgentClass::kChild));
  EXPECT_FALSE(allows(AgentClass::kScooter));
}

TEST(AllowedRequests, AreJudgedAtTheEgosPlaceAtImpact) {
  IndexedScene recording = onTwoLanes();
  for (AgentState& state : recording.scene.ego.states) {
    if (state.time > kNow + 2.0) state.pose = {0.0, 1000.0, 0.0};
  }
  EXPECT_FALSE(isAllowed(CollisionType::kRearEnd, recording));
}

TEST(AllowedRequests, IncludeAllWithoutLanes) {
  IndexedScene recording = onTwoLanes();
  recording.lanes = std::make_shared<const LaneIndex>(emptyMap());
  EXPECT_TRUE(isAllowed(CollisionType::kJunctionCrossing, recording));
}

}  // namespace
}  // namespace forge
