#include "collision_forge/ros/messages/planner_messages.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(PlannedTrajectoryMessage, NeedsItsOrientations) {
  collision_forge::PlannedTrajectory message;
  message.points.resize(2);
  message.points[0].pose.orientation.w = 1.0;
  try {
    fromMessage(message);
    ADD_FAILURE();
  } catch (const MessageError& error) {
    EXPECT_NE(std::string(error.what()).find("points[1]"), std::string::npos);
  }
  message.points[1].pose.orientation.w = 1.0;
  EXPECT_EQ(fromMessage(message).size(), 2u);
}

TEST(PlannerOutcomeMessage, HasTheContactAndNuplansScore) {
  PlannerTrial trial;
  trial.outcome.driven.push_back({100.0, {1.0, 2.0, 0.5}, 3.0, 0.0, 0.0});
  EXPECT_FALSE(toMessage(trial, "pdm", PolicyKind::kFixed).collided);
  PlannerContact contact;
  contact.other_id = "b";
  contact.time = 101.5;
  contact.at_fault = true;
  trial.outcome.contact = contact;
  trial.outcome.nuplan.comfort = 0.0;
  trial.outcome.nuplan.total = 0.25;
  trial.outcome.attacker.attacker_id = "a";
  trial.outcome.phase = AttackerPhase::kDrivingOn;
  trial.outcome.attacker_plans.push_back(
      {100.5, 100.8, AttackerPhase::kDrivingOn, "the ego jumped", {}});
  const collision_forge::PlannerOutcome message = toMessage(trial, "pdm", PolicyKind::kAdaptive);
  EXPECT_EQ(message.attacker_id, "a");
  EXPECT_EQ(message.attacker_policy, "adaptive");
  EXPECT_EQ(message.attacker_phase, "driving_on");
  EXPECT_EQ(message.attacker_plans, 1u);
  EXPECT_EQ(message.attacker_decision, "the ego jumped");
  EXPECT_EQ(message.planner, "pdm");
  EXPECT_EQ(message.other_id, "b");
  EXPECT_EQ((message.contact_time - message.header.stamp).toSec(), 1.5);
  EXPECT_TRUE(message.at_fault);
  EXPECT_EQ(message.nuplan_comfort, 0.0);
  EXPECT_EQ(message.nuplan_progress, 1.0);
  EXPECT_EQ(message.nuplan_score, 0.25);
  EXPECT_EQ(message.driven.size(), 1u);
}

}  // namespace
}  // namespace forge
