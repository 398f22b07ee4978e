#include "collision_forge/study/training/planner_samples.h"

#include <algorithm>
#include <utility>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/planners/planner_contract.h"
#include "collision_forge/planner_test/planners/planner_inputs.h"

namespace forge {
namespace {

/// How the ego was seen to move: a point a frame that has enough of it.
std::vector<TrajectoryPoint> motionsOf(const Track& ego, const std::vector<double>& frame_times) {
  std::vector<TrajectoryPoint> points;
  Track past = ego;
  past.states.clear();
  auto next = ego.states.begin();
  for (const double time : frame_times) {
    while (next != ego.states.end() && next->time <= time + 1e-6) past.states.push_back(*next++);
    const bool has_motion = static_cast<int>(past.states.size()) >= kMinHistoryFrames;
    if (!newestAt(past, time) || !has_motion) continue;
    const Motion motion = estimateMotion(past);
    points.push_back({past.states.back().time, motion.pose, std::max(motion.speed, 0.0),
                      motion.acceleration, 0.0});
  }
  return points;
}

/// The ego's states at the frames alone, as tests know them.
Track atFrames(const Track& ego, const std::vector<double>& frame_times) {
  Track track = ego;
  track.states.clear();
  for (const double time : frame_times) {
    const auto state = stateAt(ego, time);
    if (state) track.states.push_back(*state);
  }
  return track;
}

std::vector<float> part(const std::vector<float>& numbers, ContractInput input) {
  const auto start = numbers.begin() + static_cast<long>(contractStart(input));
  return {start, start + static_cast<long>(kContractInputs[input].count())};
}

void writeFuture(const Track& ego, const TrajectoryPoint& now, PlannerSample& sample) {
  sample.poses.assign(kContractOutput.count(), 0.0f);
  for (std::size_t i = 0; i < kContractPoses; ++i) {
    const auto state = stateAt(ego, now.time + static_cast<double>(i + 1) * kContractPoseStep);
    if (!state) return;
    const Pose2 local = relativeTo(now.pose, state->pose);
    float* pose = sample.poses.data() + i * kContractPoseNumbers;
    pose[0] = static_cast<float>(local.x);
    pose[1] = static_cast<float>(local.y);
    pose[2] = static_cast<float>(local.yaw);
    sample.known = i + 1;
  }
}

}  // namespace

std::vector<PlannerSample> plannerSamples(const Scene& scene,
                                          std::shared_ptr<const LaneIndex> lanes,
                                          const LearningOptions& options,
                                          const PlannerOptions& planners) {
  DrivingTask task{lanes, routeOf(scene.ego, *lanes, planners.planning.route), options.ego_vehicle,
                   planners.car.wheelbase};
  PlannerInputs inputs(task, planners.route_centerline);
  const std::vector<TrajectoryPoint> motions =
      motionsOf(atFrames(scene.ego, scene.frame_times), scene.frame_times);
  const double min_future = options.planner_training.min_future;
  std::vector<PlannerSample> samples;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::vector<TrajectoryPoint> history(motions.begin(),
                                               motions.begin() + static_cast<long>(i + 1));
    const std::vector<float> numbers = inputs.at(history, {});
    PlannerSample sample{scene.name, part(numbers, kEgoHistory), part(numbers, kRoute), {}, 0};
    writeFuture(scene.ego, motions[i], sample);
    if (static_cast<double>(sample.known) * kContractPoseStep < min_future - 1e-6) continue;
    samples.push_back(std::move(sample));
  }
  return samples;
}

std::vector<PlannerSample> collectPlannerSamples(
    const TrainingSources& sources, const LearningOptions& options, const PlannerOptions& planners,
    const std::function<void(std::size_t, std::size_t)>& on_item) {
  SceneSource scenes(sources.logs, {}, options, 1);
  const std::vector<std::string> names = scenes.names();
  std::vector<PlannerSample> samples;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto logged = scenes.at(names[i]);
    for (PlannerSample& sample : plannerSamples(logged->scene, logged->lanes, options, planners)) {
      samples.push_back(std::move(sample));
    }
    if (on_item) on_item(i + 1, names.size());
  }
  return samples;
}

}  // namespace forge
