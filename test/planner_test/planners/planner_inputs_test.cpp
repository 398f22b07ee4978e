#include "collision_forge/planner_test/planners/planner_inputs.h"

#include <gtest/gtest.h>

#include "collision_forge/planner_test/planners/planner_contract.h"
#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

/// One input tensor as rows of its last dimension.
class Input {
 public:
  Input(const std::vector<float>& all, ContractInput which) {
    const std::size_t start = contractStart(which);
    const ContractTensor& tensor = kContractInputs[which];
    width_ = tensor.sizes[tensor.dimensions - 1];
    numbers_.assign(all.begin() + static_cast<long>(start),
                    all.begin() + static_cast<long>(start + tensor.count()));
  }
  double at(std::size_t row, std::size_t column) const { return numbers_[row * width_ + column]; }
  double sum() const { return std::accumulate(numbers_.begin(), numbers_.end(), 0.0); }

 private:
  std::vector<float> numbers_;
  std::size_t width_ = 0;
};

const RouteCenterlineOptions& routeOptions() { return shippedConfig().planners.route_centerline; }

std::vector<float> inputsAt(const TrajectoryPoint& ego, const std::vector<Track>& agents) {
  PlannerInputs inputs(taskOn(threeLaneRoad()), routeOptions());
  return inputs.at({ego}, agents);
}

void expectRow(const Input& input, std::size_t row, const std::vector<double>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(input.at(row, i), expected[i], 1e-4) << "row " << row << ", column " << i;
  }
}

TEST(PlannerInputs, HaveTheSizesOfTheContract) {
  std::size_t count = 0;
  for (const ContractTensor& input : kContractInputs) count += input.count();
  EXPECT_EQ(inputsAt(egoAt({}, 5.0), {}).size(), count);
}

TEST(PlannerInputs, ContainTheObservedEgoStates) {
  PlannerInputs inputs(taskOn(threeLaneRoad()), routeOptions());
  // The ego drives from (0, 1) to (4, 1) in 1 s at 4 m/s and heads north at the end.
  TrajectoryPoint before{10.0, {0.0, 1.0, 0.5 * M_PI}, 4.0, 1.0, 0.0};
  TrajectoryPoint now{11.0, {4.0, 1.0, 0.5 * M_PI}, 6.0, 2.0, 0.0};
  const Input ego(inputs.at({before, now}, {}), kEgoHistory);
  expectRow(ego, 4, {0.0, 0.0, 0.0, 6.0, 2.0, 1.0});
  expectRow(ego, 3, {0.0, 2.0, 0.0, 5.0, 1.5, 1.0});
  expectRow(ego, 2, {0.0, 4.0, 0.0, 4.0, 1.0, 1.0});
  expectRow(ego, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
}

TEST(PlannerInputs, ContainTheNearestAgentsFirstInTheEgoFrame) {
  // The ego heads north, so places east of it are on its right.
  Track walker = agentAt("walker", {20.0, 0.0, 0.0}, 1.0, {0.6, 0.7}, AgentClass::kPedestrian);
  Track car = agentAt("car", {10.0, 0.0, M_PI}, 5.0);
  car.states.insert(car.states.begin(), {-0.5, {12.5, 0.0, M_PI}, {-5.0, 0.0}});
  const auto all = inputsAt(egoAt({0.0, 0.0, 0.5 * M_PI}, 3.0), {walker, car});
  const Input agents(all, kAgents);
  const Input mask(all, kAgentsMask);
  expectRow(agents, 4, {0.0, -10.0, 0.5 * M_PI, 0.0, 5.0, kCarSize.length, kCarSize.width, 0.0});
  expectRow(agents, 3, {0.0, -12.5, 0.5 * M_PI, 0.0, 5.0, kCarSize.length, kCarSize.width, 0.0});
  expectRow(agents, 9, {0.0, -20.0, -0.5 * M_PI, 0.0, -1.0, 0.6, 0.7, 2.0});
  expectRow(mask, 0, {0.0, 0.0, 0.0, 1.0, 1.0});
  expectRow(mask, 1, {0.0, 0.0, 0.0, 0.0, 1.0});
  EXPECT_EQ(mask.sum(), 3.0);
}

TEST(PlannerInputs, DropTheFarthestOfTooManyAgents) {
  std::vector<Track> many;
  for (std::size_t i = 0; i <= kContractAgents; ++i) {
    many.push_back(
        agentAt("car" + std::to_string(i), {100.0 - 1.0 * static_cast<double>(i), 0, 0}, 0.0));
  }
  const auto all = inputsAt(egoAt({}, 0.0), many);
  const Input agents(all, kAgents);
  EXPECT_EQ(agents.at(kContractFrames - 1, 0), 100.0 - static_cast<double>(kContractAgents));
  EXPECT_EQ(agents.at(kContractAgents * kContractFrames - 1, 0), 99.0);
}

TEST(PlannerInputs, ContainTheLanesAroundTheEgo) {
  const auto all = inputsAt(egoAt({100.0, 0.0, 0.0}, 5.0), {});
  const Input lanes(all, kLanes);
  const Input mask(all, kLanesMask);
  expectRow(lanes, 0, {-40.0, 0.0, 0.0, 0.0});
  expectRow(lanes, 10, {0.0, 0.0, 0.0, 0.0});
  expectRow(lanes, kContractLanePoints, {-40.0, 3.5, 0.0, 0.0});
  expectRow(lanes, 2 * kContractLanePoints, {40.0, 7.0, M_PI, 0.0});
  EXPECT_EQ(mask.sum(), 3.0 * kContractLanePoints);
  // 30 m before the end of two lanes and 30 m after the start of the third.
  const Input at_end(inputsAt(egoAt({370.0, 0.0, 0.0}, 5.0), {}), kLanesMask);
  EXPECT_EQ(at_end.sum(), 2.0 * (10 + 8) + kContractLanePoints);
}

TEST(PlannerInputs, ContainTheRouteFromTheEgoOn) {
  const Input route(inputsAt(egoAt({100.0, 1.0, 0.1}, 5.0), {}), kRoute);
  for (std::size_t i = 0; i < kContractRoutePoints; ++i) {
    const Pose2 expected =
        relativeTo({100.0, 1.0, 0.1}, {100.0 + 2.0 * static_cast<double>(i), 0.0, 0.0});
    expectRow(route, i, {expected.x, expected.y, expected.yaw});
  }
}

TEST(PlannerInputs, NeedLanes) {
  EXPECT_THROW(PlannerInputs({}, routeOptions()), std::invalid_argument);
}

}  // namespace
}  // namespace forge
