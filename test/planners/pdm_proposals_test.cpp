#include "collision_forge/planners/pdm_proposals.h"

#include <gtest/gtest.h>

#include "planners/planner_scenes.h"

namespace forge {
namespace {

const PdmOptions& pdmOptions() { return shippedConfig().planners.pdm; }

/// One way to the east along y = 0 from x = 0.
class PdmProposals : public testing::Test {
 protected:
  PdmProposal propose(const std::vector<Track>& agents, double speed, double offset = 0.0,
                      double desired_speed = 10.0) {
    std::set<std::string> ignored;
    const EgoVehicle& ego = shippedConfig().ego_vehicle;
    const PdmForecast forecast(agents, {{ego.center_offset, 0.0, 0.0}, ego.size}, 0.1, 80,
                               pdmOptions().agents, ignored);
    PdmProposer proposer(way_, forecast, ego, 8.0, pdmOptions());
    proposal_ = proposer.propose(0.0, speed, offset, desired_speed, 80);
    poses_ = proposer.poses(proposal_);
    return proposal_;
  }

  SampledWay way_{Polyline({{0.0, 0.0}, {300.0, 0.0}})};
  PdmProposal proposal_;
  std::vector<Pose2> poses_;
};

TEST_F(PdmProposals, AFreeRoadIsDrivenByTheModel) {
  propose({}, 5.0);
  ASSERT_EQ(proposal_.speeds.size(), 81U);
  // Slower than desired by half, the exponent 10 leaves nearly all of 1.5 m/s2.
  EXPECT_NEAR(proposal_.speeds[1], 5.0 + 0.1 * 1.5 * (1.0 - std::pow(0.5, 10.0)), 1e-9);
  EXPECT_NEAR(proposal_.arc_lengths[1], 0.5, 1e-9);
  EXPECT_NEAR(proposal_.speeds.back(), 10.0, 0.2);
}

TEST_F(PdmProposals, BrakingIsBounded) {
  propose({}, 15.0, 0.0, 3.0);
  EXPECT_NEAR(proposal_.speeds[1], 15.0 - 0.8, 1e-9);
}

TEST_F(PdmProposals, StopsBehindAStandingCarAtTheLeastGap) {
  propose({agentAt("lead", {40.0, 0.0, 0.0}, 0.0)}, 8.0);
  const EgoVehicle& ego = shippedConfig().ego_vehicle;
  const double front = proposal_.arc_lengths.back() + ego.center_offset + 0.5 * ego.size.length;
  EXPECT_LT(front, 40.0 - 2.3);
  EXPECT_GT(front, 40.0 - 2.3 - 4.0);
  EXPECT_LT(proposal_.speeds.back(), 0.5);
}

TEST_F(PdmProposals, TheLeadsSpeedCounts) {
  const double behind_fast = propose({agentAt("lead", {25.0, 0.0, 0.0}, 9.0)}, 8.0).speeds.back();
  const double behind_slow = propose({agentAt("lead", {25.0, 0.0, 0.0}, 3.0)}, 8.0).speeds.back();
  EXPECT_GT(behind_fast, 7.5);
  EXPECT_NEAR(behind_slow, 3.0, 1.0);
}

TEST_F(PdmProposals, OnlyWhoReachesIntoTheCorridorLeads) {
  const double free = propose({}, 8.0).speeds.back();
  // The corridor is 0.865 m to either side, the car 0.95 m wide on its side.
  EXPECT_EQ(propose({agentAt("beside", {40.0, 1.9, 0.0}, 0.0)}, 8.0).speeds.back(), free);
  EXPECT_LT(propose({agentAt("reaching", {40.0, 1.7, 0.0}, 0.0)}, 8.0).speeds.back(), 1.0);
  // An offset corridor passes it.
  EXPECT_EQ(propose({agentAt("reaching", {40.0, 1.7, 0.0}, 0.0)}, 8.0, -1.0).speeds.back(), free);
  EXPECT_EQ(propose({agentAt("behind", {-20.0, 0.0, 0.0}, 4.0)}, 8.0).speeds.back(), free);
}

TEST_F(PdmProposals, WhoCrossesLaterIsALeadOnlyThen) {
  // Reaches the corridor 3 s from now.
  propose({agentAt("crossing", {40.0, -18.0, 0.5 * M_PI}, 5.0)}, 8.0);
  const PdmProposal crossing = proposal_;
  const PdmProposal free = propose({}, 8.0);
  EXPECT_EQ(crossing.speeds[25], free.speeds[25]);
  EXPECT_LT(crossing.speeds[40], free.speeds[40] - 1.0);
}

TEST_F(PdmProposals, PosesAreBesideTheWay) {
  propose({}, 8.0, 1.0);
  EXPECT_NEAR(poses_[10].y, 1.0, 1e-9);
  EXPECT_NEAR(poses_[10].x, proposal_.arc_lengths[10], 1e-9);
}

}  // namespace
}  // namespace forge
