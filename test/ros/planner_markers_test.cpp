#include "collision_forge/ros/markers/planner_markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/ros/markers/marker_colors.h"

namespace forge {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// The attacker comes towards the ego, which was recorded at 8 m/s; a parked car beside.
CrashScenario scenario() {
  CrashScenario scenario;
  scenario.ego = {kEgoSize, 0.0};
  scenario.snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 8.0), {}, twoLaneRoad());
  scenario.recorded.ego = futureTrack(kEgoId, kEgoSize, {}, 8.0);
  scenario.recorded.agents = {futureTrack("parked", kCarSize, {30.0, -4.0, 0.0}, 0.0)};
  scenario.attacker = straightDrive({40.0, 0.0, M_PI}, 5.0, 6.0);
  return scenario;
}

/// The ego stands still for two seconds.
PlannerTrial standing() {
  PlannerTrial trial;
  for (int i = 0; i <= 20; ++i) trial.outcome.driven.push_back({kNow + 0.1 * i, {}});
  trial.outcome.duration = 2.0;
  trial.proposals = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}, {2.0, 1.0, 0.0}}, {}};
  return trial;
}

ShownRollout shown(const PlannerTrial& trial, const std::string& planner = "idm") {
  return shownRollout(trial, scenario(), planner, shippedOptions().verification.severity);
}

std::vector<Marker> inNamespace(const MarkerArray& array, const std::string& name_space) {
  std::vector<Marker> found;
  std::copy_if(array.markers.begin() + 1, array.markers.end(), std::back_inserter(found),
               [&](const Marker& marker) { return marker.ns == name_space; });
  return found;
}

std::string reportOf(const MarkerArray& array) {
  const auto report = inNamespace(array, "report");
  EXPECT_EQ(report.size(), 1U);
  return report.empty() ? "" : report[0].text;
}

TEST(PlannerMarkers, ShowDrivenEgoRecordedEgoAndAttackerUpToTheEnd) {
  const MarkerArray array = plannerMarkers(standing(), scenario());
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  EXPECT_EQ(array.markers.back().header.frame_id, "map");
  EXPECT_EQ(array.markers.back().header.stamp, ros::Time(kNow));
  // A ghost every half second of two.
  for (const char* name : {"ego_ghosts", "recorded_ego_ghosts", "attacker_ghosts"}) {
    EXPECT_EQ(inNamespace(array, name).size(), 5U) << name;
  }
  ASSERT_EQ(inNamespace(array, "recorded_ego_path").size(), 1U);
  const Marker recorded = inNamespace(array, "recorded_ego_path")[0];
  EXPECT_NEAR(recorded.points.back().x, 16.0, 1e-6);
  EXPECT_EQ(recorded.color, colors::toMessage(colors::kRecordedEgo));
  EXPECT_EQ(inNamespace(array, "ego_path")[0].color, colors::toMessage(colors::kEgo));
}

TEST(PlannerMarkers, ShowEveryProposalWithItsEnd) {
  const MarkerArray array = plannerMarkers(standing(), scenario());
  ASSERT_EQ(inNamespace(array, "proposals").size(), 1U);
  EXPECT_EQ(inNamespace(array, "proposals")[0].points.size(), 4U);  // two lines
  ASSERT_EQ(inNamespace(array, "proposal_ends").size(), 2U);
  EXPECT_EQ(inNamespace(array, "proposal_ends")[1].pose.position.y, 1.0);
}

constexpr double kEnd = kNow + 2.0;

TEST(RolloutMarkers, ShowAllAgentsAtTheTimeWithoutTheOutcome) {
  const MarkerArray array = rolloutMarkers(shown(standing(), "idm"), kNow + 1.0);
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  ASSERT_EQ(inNamespace(array, "ego").size(), 1U);
  ASSERT_EQ(inNamespace(array, "attacker").size(), 1U);
  EXPECT_NEAR(inNamespace(array, "attacker")[0].pose.position.x, 35.0, 1e-6);  // 5 m/s from 40 m
  EXPECT_EQ(inNamespace(array, "attacker")[0].color, colors::toMessage(colors::kAttacker));
  EXPECT_EQ(inNamespace(array, "agents").size(), 1U);
  EXPECT_TRUE(inNamespace(array, "contact").empty());
  EXPECT_EQ(reportOf(array), "idm drives, 1.0 s");
}

TEST(RolloutMarkers, ShowReactiveAgentsAsTheyDrove) {
  PlannerTrial trial = standing();
  trial.outcome.others = {futureTrack("parked", kCarSize, {50.0, -4.0, 0.0}, 0.0)};
  const MarkerArray array = rolloutMarkers(shown(trial, "idm"), kNow);
  EXPECT_NEAR(inNamespace(array, "agents")[0].pose.position.x, 50.0, 1e-6);
}

TEST(RolloutMarkers, WithoutAContactShowTheOutcomeAtTheEnd) {
  PlannerTrial trial = standing();
  const MarkerArray array = rolloutMarkers(shown(trial, "idm"), kEnd);
  EXPECT_EQ(reportOf(array), "idm: no contact in 2.00 s\nno evasive manoeuvre found");
  EXPECT_TRUE(inNamespace(array, "contact").empty());

  trial.outcome.failure = PlannerFailure::kTimedOut;
  trial.avoidability.last = Avoidance{EvasiveManoeuvre::kBraking, kNow + 1.5, {}, 0.0};
  EXPECT_EQ(reportOf(rolloutMarkers(shown(trial, "external"), kEnd)),
            "external: fails, timed_out\nafter 2.00 s\navoidable up to 1.5 s after t0 by braking");
}

TEST(RolloutMarkers, ShowTheContactAtTheEnd) {
  PlannerTrial trial = standing();
  PlannerContact contact;
  contact.other_id = "attacker";
  contact.is_attacker = true;
  contact.time = kEnd;
  contact.impact_speed = 5.0;
  contact.at_fault = false;
  trial.outcome.contact = contact;
  trial.outcome.attacker = scenario().attacker;
  const MarkerArray array = rolloutMarkers(shown(trial, "pdm"), kEnd);
  EXPECT_EQ(reportOf(array),
            "pdm: touches the attacker\nafter 2.00 s, impact 5.0 m/s\nnot at fault\n"
            "no evasive manoeuvre found");
  EXPECT_EQ(inNamespace(array, "contact").size(), 1U);
  EXPECT_TRUE(inNamespace(rolloutMarkers(shown(trial, "pdm"), kNow), "contact").empty());

  trial.outcome.contact->other_id = "parked";
  trial.outcome.contact->is_attacker = false;
  trial.outcome.contact->at_fault = true;
  const MarkerArray other = rolloutMarkers(shown(trial, "pdm"), kEnd);
  EXPECT_NE(reportOf(other).find("touches parked\n"), std::string::npos);
  EXPECT_NE(reportOf(other).find("\nat fault\n"), std::string::npos);
}

TEST(RolloutMarkers, ShowThePostCrashMotionOfTheTouchedVehicle) {
  for (const char* touched : {"attacker", "parked"}) {
    PlannerTrial trial = standing();
    for (TrajectoryPoint& point : trial.outcome.driven) point.speed = 20.0;
    trial.outcome.attacker = scenario().attacker;
    trial.outcome.contact = PlannerContact();
    trial.outcome.contact->other_id = touched;
    trial.outcome.contact->is_attacker = touched == std::string("attacker");
    trial.outcome.contact->time = kEnd;
    const ShownRollout rollout = shown(trial);
    ASSERT_GT(rollout.standTime(), kEnd + 0.5);
    const auto moved = [&](const std::string& name) {
      const auto x = [&](double time) {
        return inNamespace(rolloutMarkers(rollout, time), name)[0].pose.position.x;
      };
      return x(kEnd + 10.0) - x(kEnd);
    };
    EXPECT_GT(moved("ego"), 0.5);
    const bool is_attacker = trial.outcome.contact->is_attacker;
    EXPECT_GT(moved(is_attacker ? "attacker" : "agents"), moved("ego")) << touched << ", pushed";
    if (!is_attacker) {
      EXPECT_LT(moved("attacker"), -0.5) << "nobody stops the attacker";
    }
  }
}

TEST(RolloutMarkers, PlaceTheTextBesideOtherAgents) {
  const ShownRollout rollout = shown(standing());
  PlannerTrial trial = standing();
  trial.outcome.others = {futureTrack("parked", kCarSize, {0.0, 4.0, 0.0}, 0.0)};
  const auto y = [](const ShownRollout& of) {
    return inNamespace(rolloutMarkers(of, kEnd), "report")[0].pose.position.y;
  };
  EXPECT_GT(std::abs(y(shown(trial)) - 4.0), kCarSize.width);
  EXPECT_LT(std::abs(y(rollout) - 4.0), kCarSize.width + 2.0) << "where nobody is, it is nearer";
}

}  // namespace
}  // namespace forge
