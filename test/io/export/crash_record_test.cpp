#include "collision_forge/io/export/crash_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/export/crash_fixture.h"

namespace forge {
namespace {

using testing::HasSubstr;

std::vector<double> timesOf(const Track& track) {
  std::vector<double> times;
  for (const AgentState& state : track.states) times.push_back(state.time);
  return times;
}

const Track& otherOf(const CrashRecord& record, const std::string& id) {
  for (const Track& track : record.other_agents) {
    if (track.id == id) return track;
  }
  throw std::runtime_error("no " + id);
}

TEST(CrashRecord, BeginsAtZeroWithTheHistoryAndEndsAfterTheContact) {
  const CrashRecord record = slowCarRecord();
  EXPECT_EQ(record.name, "scene-0001_17");
  EXPECT_DOUBLE_EQ(record.now, 2.0);
  ASSERT_TRUE(record.contact.has_value());
  EXPECT_NEAR(*record.contact, 5.5, 1e-3);
  EXPECT_NEAR(record.end(), *record.contact + shippedConfig().exports.tail, 0.1);
  ASSERT_EQ(record.ego.states.size(), 66u);
  for (std::size_t i = 0; i < record.ego.states.size(); ++i) {
    EXPECT_EQ(record.ego.states[i].time, std::round(1e5 * static_cast<double>(i)) / 1e6);
  }
  EXPECT_NEAR(record.ego.states[0].pose.x, -20.0, 1e-6);
  EXPECT_NEAR(record.ego.states[50].pose.x, 30.0, 1e-6);
}

TEST(CrashRecord, AttackerIsAsRecordedThenFollowsItsTrajectory) {
  const CrashRecord record = slowCarRecord();
  EXPECT_NEAR(record.attacker.states.front().time, 1.0, 1e-9);
  EXPECT_NEAR(stateAt(record.attacker, 1.5)->pose.x, 32.0, 1e-6);
  EXPECT_NEAR(stateAt(record.attacker, 4.0)->pose.x, 36.0, 1e-6);
  EXPECT_NEAR(stateAt(record.attacker, 4.0)->velocity.x(), 2.0, 1e-6);
}

TEST(CrashRecord, AgentsAndTheAttackerKeepTheirRecordedHeights) {
  IndexedScene indexed = straightScene();
  for (Track& agent : indexed.scene.agents) agent.height = agent.id == "a" ? 1.9 : 1.2;
  const LaneArcs no_arcs;
  const Config& config = shippedConfig();
  const RecordContext context{indexed, no_arcs, config.exports, config.attack.verification};
  Scenario scenario = slowCar();
  const CrashRecord record = crashRecord(scenario, 17, 2.0, context);
  EXPECT_EQ(record.attacker.height, 1.9);
  EXPECT_EQ(otherOf(record, "walker").height, 1.2);
  scenario.answer.trajectory.attacker_id = "added_1";
  scenario.answer.trajectory.past = {{kNow, {32.0, 0.0, 0.0}, {2.0, 0.0}}};
  EXPECT_EQ(crashRecord(scenario, 17, 2.0, context).attacker.height, std::nullopt);
}

TEST(CrashRecord, AfterContactBothMoveByTheImpact) {
  const CrashRecord record = slowCarRecord();
  const double gap = stateAt(record.attacker, 5.6)->pose.x - stateAt(record.ego, 5.6)->pose.x;
  EXPECT_LT(gap, 4.0 - 5e-3) << "the boxes overlap";
  EXPECT_GT(gap, 3.5) << "as much as the vehicles deform";
  EXPECT_GT(stateAt(record.attacker, 6.4)->pose.x - stateAt(record.ego, 6.4)->pose.x, gap);
  EXPECT_LT(record.ego.states.back().velocity.norm(), stateAt(record.ego, 5.6)->velocity.norm());
}

TEST(CrashRecord, HoldsNearbyAgentsAtTheStepsInSight) {
  const CrashRecord record = slowCarRecord();
  ASSERT_EQ(record.other_agents.size(), 2u);
  EXPECT_EQ(record.other_agents[0].id, "bicycle");
  EXPECT_EQ(timesOf(otherOf(record, "walker")), timesOf(record.ego));
  const auto stretches = splitAtGaps(otherOf(record, "bicycle"), record.step);
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_NEAR(stretches[0].back().time, 1.0, 1e-9);
  EXPECT_NEAR(stretches[1].front().time, 3.0, 1e-9);
  EXPECT_NEAR(stretches[1].back().time, 4.0, 1e-9);
}

TEST(CrashRecord, WithoutAContactItEndsWithTheTrajectoryOrTheRecording) {
  Scenario scenario = slowCar();
  for (TrajectoryPoint& point : scenario.answer.trajectory.points) point.pose.y += 30.0;
  const CrashRecord ended = slowCarRecord(2.0, scenario);
  EXPECT_FALSE(ended.contact.has_value());
  EXPECT_NEAR(ended.end(), 7.0, 1e-9);
  for (int i = 51; i <= 120; ++i) {
    scenario.answer.trajectory.points.push_back(
        {kNow + 0.1 * i, {32.0 + 0.2 * i, 30.0, 0.0}, 2.0, 0.0, 0.0});
  }
  EXPECT_NEAR(slowCarRecord(2.0, scenario).end(), 8.0, 1e-9);
}

TEST(CrashRecord, AddedAttackerComesWithItsPast) {
  Scenario scenario = slowCar();
  scenario.answer.trajectory.attacker_id = "added_1";
  for (int i = -1; i <= 0; ++i) {
    scenario.answer.trajectory.past.push_back({kNow + 0.5 * i, {32.0 + i, 0.0, 0.0}, {2.0, 0.0}});
  }
  const CrashRecord record = slowCarRecord(2.0, scenario);
  EXPECT_NEAR(record.attacker.states.front().time, 1.5, 1e-9);
  EXPECT_NEAR(record.attacker.states.front().pose.x, 31.0, 1e-6);
  EXPECT_EQ(otherOf(record, "a").states.size(),
            56u);  // the recorded car is one of the other agents
}

TEST(CrashRecord, SupportsAreOtherAgents) {
  Scenario scenario = slowCar();
  SupportVehicle parked;
  parked.motion = {"parked-1", AgentClass::kCar, {4.6, 1.9}, {}};
  parked.motion.points = {{kNow, {30.0, -6.0, 0.0}}, {kNow + 4.0, {30.0, -6.0, 0.0}}};
  parked.motion.past = {{kNow - 0.5, {30.0, -6.0, 0.0}}, {kNow, {30.0, -6.0, 0.0}}};
  scenario.answer.supports = {parked};
  const CrashRecord record = slowCarRecord(2.0, scenario);
  const Track& other = otherOf(record, "parked-1");
  EXPECT_NEAR(other.states.front().time, 1.5, 1e-9);
  EXPECT_NEAR(other.states.back().time, record.end(), 1e-9);
  EXPECT_NEAR(other.states.back().pose.y, -6.0, 1e-9);
}

TEST(CrashRecord, RejectsUnsafeNamesAndAMissingEgo) {
  for (const char* name : {"../evil", "/abs", "", ".hidden", "a b"}) {
    Scenario scenario = slowCar();
    scenario.asked.scene = name;
    try {
      slowCarRecord(2.0, scenario);
      ADD_FAILURE() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("scene = \"" + std::string(name) + "\""));
    }
  }
  Scenario scenario = slowCar();
  scenario.asked.now = kNow + 100.0;
  EXPECT_THROW(slowCarRecord(2.0, scenario), std::runtime_error);
}

}  // namespace
}  // namespace forge
