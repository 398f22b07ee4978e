#include "collision_forge/planner_test/planners/pdm_proposals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const PdmOptions& pdmOptions() { return shippedConfig().planners.pdm; }

/// One way to the east along y = 0 from x = 0, with a node every metre.
class PdmProposals : public testing::Test {
 protected:
  /// The proposal at an offset (index) and with the fastest desired speed, 15 m/s.
  PdmProposal propose(const std::vector<Track>& agents, double speed, std::size_t lateral = 0) {
    std::set<std::string> ignored;
    const EgoVehicle& ego = shippedConfig().ego_vehicle;
    const PdmForecast forecast(agents, {{ego.center_offset, 0.0, 0.0}, ego.size}, 0.1, 80,
                               pdmOptions().agents, ignored);
    PdmProposer proposer(way(), {}, speed, forecast, ego, pdmOptions());
    std::vector<PdmProposal> proposals = proposer.propose(15.0);
    EXPECT_EQ(proposals.size(), 15U);
    PdmProposal proposal = proposals[5 * lateral + 4];
    EXPECT_EQ(proposal.states.size(), 41U);
    proposer.extend(proposal, 80);
    poses_ = proposer.poses(proposal);
    return proposal;
  }

  static PdmPath way() {
    std::vector<Pose2> nodes;
    for (int x = 0; x <= 300; ++x) nodes.push_back({1.0 * x, 0.0, 0.0});
    return PdmPath(nodes);
  }

  std::vector<Pose2> poses_;
};

TEST_F(PdmProposals, TheFirstStepBrakes) {
  const PdmProposal proposal = propose({}, 5.0);
  EXPECT_NEAR(proposal.states[1].speed, 5.0 - 0.1 * pdmOptions().idm.braking, 1e-9);
  EXPECT_NEAR(proposal.states[1].progress, 0.5, 1e-9);
}

TEST_F(PdmProposals, AFreeRoadIsDrivenByTheModel) {
  const PdmProposal proposal = propose({}, 5.0);
  ASSERT_EQ(proposal.states.size(), 81U);
  ASSERT_EQ(poses_.size(), 81U);
  // The end of the path, 300 m away, hardly counts.
  const double slope = (proposal.states[10].speed - proposal.states[1].speed) / 0.9;
  EXPECT_NEAR(slope, pdmOptions().idm.max_acceleration, 0.05);
}

TEST_F(PdmProposals, StopsBehindAStandingCar) {
  const PdmProposal proposal = propose({agentAt("lead", {40.0, 0.0, 0.0}, 0.0)}, 8.0);
  const EgoVehicle& ego = shippedConfig().ego_vehicle;
  const double front = proposal.states.back().progress + ego.center_offset + 0.5 * ego.size.length;
  EXPECT_LT(front, 40.0 - 2.3);
  EXPECT_GT(front, 40.0 - 2.3 - 4.0);
  EXPECT_LT(proposal.states.back().speed, 0.6);
}

TEST_F(PdmProposals, TheLeadsSpeedCounts) {
  const auto behind = [&](double speed) {
    return propose({agentAt("lead", {25.0, 0.0, 0.0}, speed)}, 8.0).states.back().speed;
  };
  EXPECT_GT(behind(9.0), 7.5);
  EXPECT_NEAR(behind(3.0), 3.0, 1.0);
}

TEST_F(PdmProposals, OnlyWhoReachesIntoTheCorridorLeads) {
  const double free = propose({}, 8.0).states.back().speed;
  const auto last = [&](const Track& agent, std::size_t lateral = 0) {
    return propose({agent}, 8.0, lateral).states.back().speed;
  };
  // The corridor is 0.865 m to either side, the car 0.95 m wide on its side.
  EXPECT_EQ(last(agentAt("beside", {40.0, 1.9, 0.0}, 0.0)), free);
  EXPECT_LT(last(agentAt("reaching", {40.0, 1.7, 0.0}, 0.0)), 1.0);
  // A corridor 1 m to the right passes it.
  EXPECT_NEAR(last(agentAt("reaching", {40.0, 1.7, 0.0}, 0.0), 1), free, 1e-9);
  EXPECT_EQ(last(agentAt("behind", {-20.0, 0.0, 0.0}, 1.0)), free);
}

TEST_F(PdmProposals, WhoCrossesLaterIsALeadOnlyThen) {
  // Reaches the corridor about 3 s from now.
  const PdmProposal crossing = propose({agentAt("crossing", {40.0, -18.0, 0.5 * M_PI}, 5.0)}, 8.0);
  const PdmProposal free = propose({}, 8.0);
  EXPECT_EQ(crossing.states[25].speed, free.states[25].speed);
  EXPECT_LT(crossing.states[40].speed, free.states[40].speed - 1.0);
}

TEST_F(PdmProposals, PosesAreBesideTheWay) {
  const PdmProposal proposal = propose({}, 8.0, 2);
  EXPECT_NEAR(poses_[10].y, pdmOptions().lateral_offsets[2], 1e-9);
  EXPECT_NEAR(poses_[10].x, proposal.states[10].progress, 1e-9);
}

}  // namespace
}  // namespace forge
