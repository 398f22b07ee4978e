#include "collision_forge/ros/messages/attack_request.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(AttackRequest, RecordsRequestMethodAndConfiguration) {
  CollisionRequest request;
  request.type = CollisionType::kRearEnd;
  request.tta = 4.0;
  request.seed = 7;
  collision_forge::Attack attack;
  attack.header.stamp = ros::Time(12.5);
  attack.header.frame_id = "map";
  attack.method = "search";
  const auto message = attackRequest(request, attack, "abc", 2);
  EXPECT_EQ(message.header, attack.header);
  EXPECT_EQ(message.request.collision_type, "rear_end");
  EXPECT_EQ(message.request.tta, 4.0);
  EXPECT_EQ(message.request.seed, 7u);
  EXPECT_EQ(message.method, "search");
  EXPECT_EQ(message.configuration, "abc");
  EXPECT_EQ(message.alternative, 2u);
  EXPECT_FALSE(message.version.empty());
  EXPECT_EQ(message.bag, "");
}

}  // namespace
}  // namespace forge
