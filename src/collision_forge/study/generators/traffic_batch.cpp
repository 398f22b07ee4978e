#include "collision_forge/study/generators/traffic_batch.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

std::size_t mostAgents(const std::vector<TrafficWindow>& windows) {
  std::size_t most = 0;
  for (const TrafficWindow& window : windows) most = std::max(most, window.clip->agents.size());
  return most;
}

/// Adds the lanes near ego or attacker at t0 of each window.
void addLanes(const std::vector<TrafficWindow>& windows, const TrafficLaneOptions& options,
              TrafficBatch& batch) {
  std::vector<std::vector<const TrafficLane*>> nearest;
  std::size_t most = 0;
  for (const auto& [clip, now] : windows) {
    const auto frame = static_cast<std::size_t>(now);
    nearest.push_back(nearestLanes(clip->lanes,
                                   {clip->agents[kEgoAgent][frame]->position(),
                                    clip->agents[kAttackerAgent][frame]->position()},
                                   options.max_lanes));
    most = std::max(most, nearest.back().size());
  }
  const auto count = static_cast<long>(windows.size());
  const auto pieces = static_cast<long>(most);
  batch.lanes = torch::zeros({count, pieces, options.points, kLaneNumbers});
  batch.lane_seen = torch::zeros({count, pieces, options.points});
  auto lanes = batch.lanes.accessor<float, 4>();
  auto seen = batch.lane_seen.accessor<float, 3>();
  for (long b = 0; b < count; ++b) {
    const auto& [clip, now] = windows[static_cast<std::size_t>(b)];
    const Pose2 origin = *clip->agents[kEgoAgent][static_cast<std::size_t>(now)];
    const auto& found = nearest[static_cast<std::size_t>(b)];
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto row = static_cast<long>(i);
      for (std::size_t p = 0; p < found[i]->points.size(); ++p) {
        const Pose2 point = relativeTo(origin, found[i]->points[p]);
        auto numbers = lanes[b][row][static_cast<long>(p)];
        numbers[0] = static_cast<float>(point.x);
        numbers[1] = static_cast<float>(point.y);
        numbers[2] = static_cast<float>(std::cos(point.yaw));
        numbers[3] = static_cast<float>(std::sin(point.yaw));
        numbers[4] = found[i]->is_intersection ? 1.0f : 0.0f;
        seen[b][row][static_cast<long>(p)] = 1.0f;
      }
    }
  }
}

}  // namespace

TrafficBatch batchOf(const std::vector<TrafficWindow>& windows, const TrafficOptions& options,
                     int future_frames) {
  const auto count = static_cast<long>(windows.size());
  const auto agents = static_cast<long>(mostAgents(windows));
  const long frames = options.history_frames + future_frames;
  TrafficBatch batch{torch::zeros({count, agents, frames, 3}),
                     torch::zeros({count, agents, frames}),
                     torch::zeros({count, kConditionNumbers}),
                     {},
                     {}};
  auto poses = batch.poses.accessor<float, 4>();
  auto seen = batch.seen.accessor<float, 3>();
  auto condition = batch.condition.accessor<float, 2>();
  for (long b = 0; b < count; ++b) {
    const auto& [clip, now] = windows[static_cast<std::size_t>(b)];
    const Pose2 origin = *clip->agents[kEgoAgent][static_cast<std::size_t>(now)];
    for (std::size_t a = 0; a < clip->agents.size(); ++a) {
      const AgentFrames& known = clip->agents[a];
      for (long t = 0; t < frames; ++t) {
        const auto frame = static_cast<std::size_t>(now - options.history_frames + 1 + t);
        if (frame >= known.size() || !known[frame]) continue;
        const Pose2 pose = relativeTo(origin, *known[frame]);
        const auto row = static_cast<long>(a);
        poses[b][row][t][0] = static_cast<float>(pose.x);
        poses[b][row][t][1] = static_cast<float>(pose.y);
        poses[b][row][t][2] = static_cast<float>(pose.yaw);
        seen[b][row][t] = 1.0f;
      }
    }
    condition[b][static_cast<long>(clip->type)] = 1.0f;
    condition[b][kConditionNumbers - 1] =
        static_cast<float>((clip->collision_frame - now - 1) / kTtaFrames);
  }
  addLanes(windows, options.lanes, batch);
  return batch;
}

std::vector<TrafficWindow> windowsOf(const TrafficClip& clip, const TrafficOptions& options) {
  std::vector<TrafficWindow> windows;
  const int first = options.history_frames - 1;
  const int last = std::max(first, clip.collision_frame - options.future_frames);
  for (int now = first; now <= last; ++now) windows.push_back({&clip, now});
  return windows;
}

TrafficBatch historyOf(const TrafficBatch& batch, int history_frames) {
  return {batch.poses.slice(2, 0, history_frames), batch.seen.slice(2, 0, history_frames),
          batch.condition, batch.lanes, batch.lane_seen};
}

TrafficBatch movedTo(const TrafficBatch& batch, torch::Device device) {
  return {batch.poses.to(device), batch.seen.to(device), batch.condition.to(device),
          batch.lanes.to(device), batch.lane_seen.to(device)};
}

torch::Tensor seenThroughout(const TrafficBatch& batch, int frames) {
  return batch.seen.slice(2, 0, frames).amin(2);
}

}  // namespace forge
