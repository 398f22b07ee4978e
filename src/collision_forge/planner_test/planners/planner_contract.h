#pragma once

#include <array>
#include <cstddef>

namespace forge {

// What a learned planner is given and gives back, as docs/learned_planner.md has it. Nothing of it
// can be tuned: files are made for it.

inline constexpr std::size_t kContractFrames = 5;        ///< of the past, the last is now
inline constexpr double kContractFrameStep = 0.5;        ///< s between them
inline constexpr std::size_t kContractAgents = 64;       ///< nearest first
inline constexpr std::size_t kContractLanes = 64;        ///< nearest first
inline constexpr std::size_t kContractLanePoints = 20;   ///< in driving direction
inline constexpr double kContractLaneSpacing = 4.0;      ///< m between them
inline constexpr double kContractLaneRadius = 60.0;      ///< m around the ego
inline constexpr std::size_t kContractRoutePoints = 50;  ///< the first beside the ego
inline constexpr double kContractRouteSpacing = 2.0;     ///< m between them
inline constexpr std::size_t kContractPoses = 80;        ///< that are planned
inline constexpr double kContractPoseStep = 0.1;  ///< s between them; the first so long after now
inline constexpr std::size_t kContractEgoNumbers = 6;    ///< x, y, yaw, speed, acceleration, known
inline constexpr std::size_t kContractAgentNumbers = 8;  ///< x, y, yaw, vx, vy, length, width, kind
inline constexpr std::size_t kContractLaneNumbers = 4;   ///< x, y, yaw, in an intersection
inline constexpr std::size_t kContractPoseNumbers = 3;   ///< x, y, yaw

/// A tensor of 32-bit floats, row by row.
struct ContractTensor {
  const char* name;
  std::array<std::size_t, 3> sizes;
  std::size_t dimensions;

  constexpr std::size_t count() const {
    std::size_t product = 1;
    for (std::size_t i = 0; i < dimensions; ++i) product *= sizes[i];
    return product;
  }
};

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

/// Where the numbers of an input begin among those of all, which lie one after the other.
constexpr std::size_t contractStart(std::size_t input) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < input; ++i) start += kContractInputs[i].count();
  return start;
}

/// The numbers of all inputs.
inline constexpr std::size_t kContractNumbers = contractStart(kContractInputs.size());

/// What forward() returns.
inline constexpr ContractTensor kContractOutput = {
    "the output", {kContractPoses, kContractPoseNumbers, 0}, 2};

// How the suite speaks with the process that runs a file, over one stream of bytes. The process
// begins with an answer: whether the file can be used. Then it answers request by request.

/// A new rollout: what the planner remembers is forgotten. The answer has no numbers.
inline constexpr char kRequestBegin = 'b';
/// Followed by the numbers of all inputs; the answer has those of the output.
inline constexpr char kRequestPlan = 'p';
/// An answer: this, then the numbers, if any.
inline constexpr char kAnswerOk = 'k';
/// An answer: this, then the length of a text (32 bits) and the text, which says what is wrong.
inline constexpr char kAnswerError = 'e';

}  // namespace forge
