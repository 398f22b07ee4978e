#pragma once

#include <array>
#include <cstddef>

namespace forge {

// Input and output formats of a learned planner and of a learned traffic model, as
// docs/learned_planner.md defines them. These numbers are fixed: model files depend on them.

inline constexpr std::size_t kContractFrames = 5;  ///< frames, oldest first; the last is now
inline constexpr double kContractFrameStep = 0.5;  ///< s between them
/// Greatest number of agents; nearest to the ego first.
inline constexpr std::size_t kContractAgents = 64;
/// Greatest number of lanes; nearest to the ego first.
inline constexpr std::size_t kContractLanes = 64;
/// Greatest number of points of a lane, in driving direction: from 40 m (at most) before its point
/// nearest to the middle of the ego's box up to the lane's end at most.
inline constexpr std::size_t kContractLanePoints = 20;
inline constexpr double kContractLaneSpacing = 4.0;  ///< m between them
/// m around the middle of the ego's box; lanes farther away are left out.
inline constexpr double kContractLaneRadius = 60.0;
/// Points ahead along the centreline of the route; the first is beside the ego, points beyond its
/// end are straight ahead of it.
inline constexpr std::size_t kContractRoutePoints = 50;
inline constexpr double kContractRouteSpacing = 2.0;  ///< m between them
inline constexpr std::size_t kContractPoses = 80;     ///< poses of a plan
/// s between them; the first is one step after the call.
inline constexpr double kContractPoseStep = 0.1;
/// x, y, yaw, speed, acceleration, is_known (1, or 0 if the frame is before the first state).
inline constexpr std::size_t kContractEgoNumbers = 6;
/// x, y, yaw, vx, vy (of the agent, in the ego's current frame), length, width, class (0 vehicle, 1
/// two-wheeler, 2 pedestrian or animal, 3 static object).
inline constexpr std::size_t kContractAgentNumbers = 8;
inline constexpr std::size_t kContractLaneNumbers = 4;  ///< x, y, yaw, is_in_intersection (1 or 0)
inline constexpr std::size_t kContractPoseNumbers = 3;  ///< x, y, yaw of the middle of a box

/// Shape of a tensor of 32-bit floats in row-major order.
struct ContractTensor {
  const char* name;  ///< of the input; for messages and to check the arguments of forward()
  /// Elements per dimension, outermost first; 0 beyond `dimensions`.
  std::array<std::size_t, 3> sizes;
  std::size_t dimensions;  ///< number of valid `sizes`

  /// Returns the number of elements.
  constexpr std::size_t count() const {
    std::size_t product = 1;
    for (std::size_t i = 0; i < dimensions; ++i) product *= sizes[i];
    return product;
  }
};

/// Index into kContractInputs; the enumerators have the order and the meaning of its elements.
enum ContractInput { kEgoHistory, kAgents, kAgentsMask, kLanes, kLanesMask, kRoute };

/// The arguments of forward() of a planner, in this order. Masks have 1 where an entry is used,
/// else 0.
inline constexpr std::array<ContractTensor, 6> kContractInputs = {{
    {"ego_history", {kContractFrames, kContractEgoNumbers, 0}, 2},
    {"agents", {kContractAgents, kContractFrames, kContractAgentNumbers}, 3},
    {"agents_mask", {kContractAgents, kContractFrames, 0}, 2},
    {"lanes", {kContractLanes, kContractLanePoints, kContractLaneNumbers}, 3},
    {"lanes_mask", {kContractLanes, kContractLanePoints, 0}, 2},
    {"route", {kContractRoutePoints, kContractPoseNumbers, 0}, 2},
}};

/// Returns the index of the first number of `input` (a ContractInput) in the concatenation of all
/// kContractInputs.
constexpr std::size_t contractStart(std::size_t input) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < input; ++i) start += kContractInputs[i].count();
  return start;
}

/// Number of values in all kContractInputs together.
inline constexpr std::size_t kContractNumbers = contractStart(kContractInputs.size());

/// The return value of forward() of a planner: poses of the ego in its current frame.
inline constexpr ContractTensor kContractOutput = {
    "the output", {kContractPoses, kContractPoseNumbers, 0}, 2};

/// The arguments of forward() of a traffic model: the first five of a planner, and "step", the time
/// (s) from now to the poses of the output.
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
  const char* name;  ///< "planner" or "traffic"; also an argument of the worker process
  const std::array<ContractTensor, 6>& inputs;  ///< arguments of forward(), in order
  ContractTensor output;                        ///< return value of forward()

  /// Returns the number of values in all inputs together.
  constexpr std::size_t numbers() const {
    std::size_t sum = 0;
    for (const ContractTensor& input : inputs) sum += input.count();
    return sum;
  }
};

/// Contract of a learned planner.
inline constexpr ModelContract kPlannerContract = {"planner", kContractInputs, kContractOutput};
/// Contract of a traffic model. The output: the pose of each agent of `agents` in their order,
/// `step` seconds from now, in the ego's current frame; rows of unused entries are ignored.
inline constexpr ModelContract kTrafficContract = {
    "traffic", kTrafficInputs, {"the output", {kContractAgents, kContractPoseNumbers, 0}, 2}};

// Protocol between the test suite and the worker process that runs a model file, over one byte
// stream. The worker first sends one reply: whether the file is usable. Then it replies to each
// request. Numbers are 32-bit floats in the machine's byte order.

/// Request: start a new rollout and reset the planner's state. The reply has no numbers.
inline constexpr char kRequestBegin = 'b';
/// Request: plan. Followed by the numbers of all inputs; the reply has the numbers of the output.
inline constexpr char kRequestPlan = 'p';
/// Reply: success, followed by the numbers, if any.
inline constexpr char kAnswerOk = 'k';
/// Reply: failure, followed by the length of the error message (32 bits) and the message.
inline constexpr char kAnswerError = 'e';

}  // namespace forge
