#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/study/training/training_data.h"

namespace forge {

/// A moment of a log for a learned planner: what it is given of its own way, and where the ego then
/// went, in the frame of the ego now (planner_test/planners/planner_contract.h).
struct PlannerSample {
  std::string scene;
  std::vector<float> ego_history;
  std::vector<float> route;
  std::vector<float> poses;  ///< of the contract's output; 0 where the recording has ended
  std::size_t known = 0;     ///< poses before it ends
};

/// A moment of each frame of a recording's ego, as a test would show it: motion told from the past
/// alone, the route that of the recording and the lanes after it. Those with less future than
/// `min_future` are left out.
std::vector<PlannerSample> plannerSamples(const Scene& scene,
                                          std::shared_ptr<const LaneIndex> lanes,
                                          const LearningOptions& options,
                                          const PlannerOptions& planners);

/// The samples of all logs of `sources`, in the order of the table. `on_item` is told logs done, of
/// how many.
std::vector<PlannerSample> collectPlannerSamples(
    const TrainingSources& sources, const LearningOptions& options, const PlannerOptions& planners,
    const std::function<void(std::size_t, std::size_t)>& on_item);

}  // namespace forge
