#include "collision_forge/planner_test/planners/background_model.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "collision_forge/planner_test/planners/planner_contract.h"
#include "collision_forge/planner_test/planners/planner_inputs.h"

namespace forge {

BackgroundModel::BackgroundModel(const TorchscriptOptions& options,
                                 std::shared_ptr<const LaneIndex> lanes)
    : options_(options),
      lanes_(std::move(lanes)),
      worker_(options.workers->take(options, workerKey(options))) {}

BackgroundModel::~BackgroundModel() { options_.workers->giveBack(std::move(worker_)); }

std::map<std::string, Pose2> BackgroundModel::next(const std::vector<TrajectoryPoint>& ego_history,
                                                   const std::vector<Track>& agents, double step) {
  std::vector<float> numbers = sharedInputs(*lanes_, ego_history, agents);
  numbers.push_back(static_cast<float>(step));
  worker_->begin();
  const std::vector<float> poses = worker_->plan(numbers);
  const Pose2& ego = ego_history.back().pose;
  const std::vector<const Track*> nearest = nearestAgents(agents, ego);
  std::map<std::string, Pose2> found;
  for (std::size_t i = 0; i < std::min(nearest.size(), kContractAgents); ++i) {
    const float* pose = poses.data() + i * kContractPoseNumbers;
    const Pose2 local{pose[0], pose[1], pose[2]};
    if (!local.isFinite()) {
      throw std::runtime_error(options_.file + ": the pose of agent " + std::to_string(i + 1) +
                               " in the output is not finite");
    }
    found[nearest[i]->id] = compose(ego, local);
  }
  return found;
}

}  // namespace forge
