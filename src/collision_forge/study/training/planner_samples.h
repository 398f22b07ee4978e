#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/study/training/training_data.h"

namespace forge {

/// A training sample for a learned planner: inputs and the recorded motion as target, in the ego's
/// frame at t0, in the layout of planner_test/planners/planner_contract.h.
struct PlannerSample {
  std::string scene;               ///< name
  std::vector<float> ego_history;  ///< input kEgoHistory of the contract
  std::vector<float> route;        ///< input kRoute of the contract
  std::vector<float> poses;        ///< target, output of the contract; 0 after the recording's end
  std::size_t known = 0;           ///< number of recorded poses in `poses`
};

/// Returns one sample per frame of a recording, with the same inputs as in a planner test: motion
/// estimated from past frames only, the recorded route continued along lanes. Omits frames with a
/// recorded future shorter than `min_future`.
std::vector<PlannerSample> plannerSamples(const Scene& scene,
                                          std::shared_ptr<const LaneIndex> lanes,
                                          const LearningOptions& options,
                                          const PlannerOptions& planners);

/// Returns the samples of all scenes of `sources.logs`, in the order of SceneSource::names(). Calls
/// `on_item` after each scene with the numbers of scenes done and in total.
std::vector<PlannerSample> collectPlannerSamples(
    const TrainingSources& sources, const LearningOptions& options, const PlannerOptions& planners,
    const std::function<void(std::size_t, std::size_t)>& on_item);

}  // namespace forge
