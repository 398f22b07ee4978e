#pragma once

#include <array>
#include <cstddef>

namespace forge {

// Input and output formats of a learned planner and of a learned traffic model, as
// docs/learned_planner.md defines them. These numbers are fixed: model files depend on them.

inline constexpr std::size_t kContractFrames = 5;   ///< past frames; the last is the current one
inline constexpr double kContractFrameStep = 0.5;   ///< s between them
inline constexpr std::size_t kContractAgents = 64;  ///< nearest first
inline constexpr std::size_t kContractLanes = 64;   ///< nearest first
inline constexpr std::size_t kContractLanePoints = 20;   ///< in driving direction
inline constexpr double kContractLaneSpacing = 4.0;      ///< m between them
inline constexpr double kContractLaneRadius = 60.0;      ///< m around the ego
inline constexpr std::size_t kContractRoutePoints = 50;  ///< the first is beside the ego
inline constexpr double kContractRouteSpacing = 2.0;     ///< m between them
inline constexpr std::size_t kContractPoses = 80;        ///< poses of a plan
inline constexpr double kContractPoseStep =
    0.1;  ///< s between them; the first is one step after the call
inline constexpr std::size_t kContractEgoNumbers = 6;  ///< x, y, yaw, speed, acceleration, is_known
inline constexpr std::size_t kContractAgentNumbers =
    8;                                                  ///< x, y, yaw, vx, vy, length, width, class
inline constexpr std::size_t kContractLaneNumbers = 4;  ///< x, y, yaw, is_in_intersection
inline constexpr std::size_t kContractPoseNumbers = 3;  ///< x, y, yaw

/// Shape of a tensor of 32-bit floats in row-major order.
struct ContractTensor {
  const char* name;                  ///< for messages
  std::array<std::size_t, 3> sizes;  ///< elements per dimension
  std::size_t dimensions;            ///< number of valid `sizes`

  /// Returns the number of elements.
  constexpr std::size_t count() const {
    std::size_t product = 1;
    for (std::size_t i = 0; i < dimensions; ++i) product *= sizes[i];
    return product;
  }
};

/// Index into kContractInputs.
enum ContractInput { kEgoHistory, kAgents, kAgentsMask, kLanes, kLanesMask, kRoute };

/// The arguments of forward(), in this order.
inline constexpr std::array<ContractTensor, 6> kContractInputs = {{
    {"ego_history", {kContractFrames, kContractEgoNumbers, 0}, 2},
    {"agents", {kContractAgents, kContractFrames, kContractAgentNumbers}, 3},
    {"agents_mask", {kContractAgents, kContractFrames, 0}, 2},
    {"lanes", {kContractLanes, kContractLanePoints, kContractLaneNumbers}, 3},
    {"lanes_mask", {kContractLanes, kContractLanePoints, 0}, 2},
    {"route", {kContractRoutePoints, kContractPoseNumbers, 0}, 2},
}};

/// Returns the index of the first number of `input` in the concatenation of all inputs.
constexpr std::size_t contractStart(std::size_t input) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < input; ++i) start += kContractInputs[i].count();
  return start;
}

/// Number of values in all inputs together.
inline constexpr std::size_t kContractNumbers = contractStart(kContractInputs.size());

/// The return value of forward().
inline constexpr ContractTensor kContractOutput = {
    "the output", {kContractPoses, kContractPoseNumbers, 0}, 2};

/// The arguments of forward() of a traffic model: the first ones of a planner, and the time, s,
/// from now to the poses of the output.
inline constexpr std::array<ContractTensor, 6> kTrafficInputs = {{
    kContractInputs[kEgoHistory],
    kContractInputs[kAgents],
    kContractInputs[kAgentsMask],
    kContractInputs[kLanes],
    kContractInputs[kLanesMask],
    {"step", {1, 0, 0}, 1},
}};

/// Inputs and output of a model file.
struct ModelContract {
  const char* name;  ///< also an argument of the worker process
  const std::array<ContractTensor, 6>& inputs;
  ContractTensor output;

  /// Returns the number of values in all inputs together.
  constexpr std::size_t numbers() const {
    std::size_t sum = 0;
    for (const ContractTensor& input : inputs) sum += input.count();
    return sum;
  }
};

inline constexpr ModelContract kPlannerContract = {"planner", kContractInputs, kContractOutput};
/// The output: the next pose of each agent of `agents`.
inline constexpr ModelContract kTrafficContract = {
    "traffic", kTrafficInputs, {"the output", {kContractAgents, kContractPoseNumbers, 0}, 2}};

// Protocol between the test suite and the worker process that runs a model file, over one byte
// stream. The worker first sends one reply: whether the file is usable. Then it replies to each
// request.

/// Request: start a new rollout and reset the planner's state. The reply has no numbers.
inline constexpr char kRequestBegin = 'b';
/// Request: plan. Followed by the numbers of all inputs; the reply has the numbers of the output.
inline constexpr char kRequestPlan = 'p';
/// Reply: success, followed by the numbers, if any.
inline constexpr char kAnswerOk = 'k';
/// Reply: failure, followed by the length of the error message (32 bits) and the message.
inline constexpr char kAnswerError = 'e';

}  // namespace forge
