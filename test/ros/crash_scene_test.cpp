#include "collision_forge/ros/markers/crash_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace forge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNow = 10.0;      // s
constexpr double kContact = 11.0;  // s
const OrientedBox kEgoBox{{3.0, 0.0, 0.0}, {4.0, 2.0}};

std_msgs::Header headerAt(double time) {
  std_msgs::Header header;
  header.stamp = ros::Time(time);
  header.frame_id = "map";
  return header;
}

collision_forge::Agent agent(const std::string& id, std::uint8_t agent_class, double x) {
  collision_forge::Agent agent;
  agent.id = id;
  agent.agent_class = agent_class;
  agent.size.x = 4.6;
  agent.size.y = 1.9;
  agent.size.z = 1.6;
  agent.pose.position.x = x;
  agent.pose.position.z = 7.0;
  agent.pose.orientation.w = 1.0;
  agent.velocity.x = 3.0;
  agent.velocity.y = 4.0;
  return agent;
}

/// Along x from x = 30 to 0, 2 s long; at the contact it is at 15, where the ego's front is 5.
collision_forge::Attack attack() {
  collision_forge::Attack attack;
  attack.header = headerAt(kNow);
  attack.trajectory.attacker_id = "attacker-1";
  attack.trajectory.size.x = 4.6;
  attack.trajectory.size.y = 1.9;
  for (int i = 0; i <= 4; ++i) {
    attack.trajectory.points.emplace_back();
    attack.trajectory.points.back().stamp = ros::Time(kNow + 0.5 * i);
    attack.trajectory.points.back().pose.position.x = 30.0 - 7.5 * i;
    attack.trajectory.points.back().pose.orientation.w = 1.0;
  }
  attack.pattern.ego_size.x = 4.0;
  attack.pattern.ego_size.y = 2.0;
  attack.report.header = attack.header;
  attack.report.attacker_id = "attacker-1";
  attack.report.contact = attack.report.verified = attack.report.believable = true;
  attack.report.contact_time = ros::Time(kContact);
  attack.report.ego_at_contact.x = 10.7;
  attack.report.attacker_at_contact.x = 15.0;
  return attack;
}

collision_forge::AgentArray frameOf(std::vector<collision_forge::Agent> agents) {
  collision_forge::AgentArray frame;
  frame.agents = std::move(agents);
  return frame;
}

std::vector<std::string> idsOf(const SceneUpdate& update) {
  std::vector<std::string> ids;
  for (const SceneEntity& entity : update.entities) ids.push_back(entity.id);
  return ids;
}

const SceneEntity& entityOf(const SceneUpdate& update, const std::string& id) {
  return *std::find_if(update.entities.begin(), update.entities.end(),
                       [&](const SceneEntity& entity) { return entity.id == id; });
}

/// What is shown at a time with the attack in it.
SceneUpdate attackedAt(double time) {
  const auto frame = frameOf({agent("attacker-1", 0, 20.0), agent("other", 0, 50.0)});
  const auto crash = attack();
  return crashScene({headerAt(time), kEgoBox, &crash, frame.agents.data()}, frame);
}

TEST(MapScene, ShowsLanesConnectorsAndEdges) {
  collision_forge::LaneMap map;
  map.header = headerAt(1.0);
  map.lanes.resize(2);
  map.lanes[0].centerline.resize(3);
  map.lanes[1].centerline.resize(2);
  map.lanes[1].is_connector = true;
  map.drivable_area.resize(1);
  map.drivable_area[0].exterior.points.resize(4);
  map.drivable_area[0].holes.resize(1);
  map.drivable_area[0].holes[0].points.resize(3);
  const SceneUpdate update = mapScene(map);
  EXPECT_EQ(update.frame_id, "map");
  EXPECT_EQ(update.stamp, ros::Time(1.0));
  EXPECT_EQ(entityOf(update, "lanes").lines.at(0).points.size(), 2U * 2);
  EXPECT_EQ(entityOf(update, "connectors").lines.at(0).points.size(), 2U * 1);
  EXPECT_EQ(entityOf(update, "drivable_area").lines.at(0).points.size(), 2U * (4 + 3))
      << "rings are closed";
}

TEST(CrashScene, ShowsBoxesOnTheGroundWithLabels) {
  const auto frame = frameOf({agent("0123456789", 1, 20.0), agent("cone", 10, 50.0)});
  const SceneUpdate update = crashScene({headerAt(kNow), kEgoBox, nullptr, nullptr}, frame);
  EXPECT_THAT(idsOf(update), ElementsAre("ego", "agent 0123456789", "agent cone"));
  const SceneEntity& truck = entityOf(update, "agent 0123456789");
  EXPECT_EQ(truck.cubes.at(0).pose.position.x, 20.0);
  EXPECT_EQ(truck.cubes.at(0).pose.position.z, 0.8);
  EXPECT_EQ(truck.cubes.at(0).size.z, 1.6);
  EXPECT_EQ(truck.texts.at(0).text, "truck 012345");
  EXPECT_GT(truck.texts.at(0).middle.z, 1.6);
  EXPECT_THAT(truck.metadata,
              ElementsAre(std::pair("id", "0123456789"), std::pair("class", "truck"),
                          std::pair("speed", "5.0 m/s")));
  EXPECT_EQ(entityOf(update, "ego").texts.at(0).text, "ego");
  EXPECT_THAT(entityOf(update, "agent cone").texts, IsEmpty());
}

TEST(CrashScene, ShowsThePathToTheContactAndTheContactPoint) {
  const SceneUpdate update = attackedAt(kNow + 0.5);
  const SceneEntity& shown = entityOf(update, "attack");
  ASSERT_EQ(shown.lines.size(), 3U) << "the way and both boxes";
  EXPECT_EQ(shown.lines[0].points.size(), 2U * 2);
  EXPECT_EQ(shown.lines[0].points.back().x, 15.0);
  EXPECT_EQ(shown.lines[1].points.size(), 2U * 4);
  EXPECT_NEAR(shown.spheres.at(0).pose.position.x, 12.7, 0.01);
  EXPECT_EQ(shown.texts.at(0).text, "contact in 0.5 s");
}

}  // namespace
}  // namespace forge
