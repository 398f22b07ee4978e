#include "collision_forge/attack/forecast/speed_profile_collection.h"

#include <cmath>

#include "collision_forge/attack/forecast/ego_paths.h"

namespace forge {
namespace {

constexpr double kFollowedSeconds = 6.0;  // s of recorded driving that select the followed path
constexpr double kStepTolerance = 0.25;   // s, deviation of the frame interval from kProfileStep
constexpr int kPastFrames = 2;            // frames from which other agents' velocities are derived

std::vector<Vector2> positionsAfter(const Track& ego, double now) {
  std::vector<Vector2> positions;
  for (double after = 0.0; after <= kFollowedSeconds; after += kProfileStep) {
    const auto state = stateAt(ego, now + after);
    if (state) positions.push_back(state->pose.position());
  }
  return positions;
}

/// Returns the ego's past states for egoNow().
Track completePast(const Track& ego, double now) {
  Track past{ego.id, ego.agent_class, ego.size, {}};
  for (double before = 2.5; before > -0.25; before -= kProfileStep) {
    const auto state = stateAt(ego, now - before);
    if (state) past.states.push_back(*state);
  }
  return past;
}

}  // namespace

std::vector<SpeedProfileRow> collectSpeedProfiles(const Scene& scene, const LaneIndex& lanes) {
  std::vector<SpeedProfileRow> rows;
  int frame = 0;
  for (std::size_t i = 1; i < scene.frame_times.size(); ++i) {
    const double now = scene.frame_times[i];
    const double step = now - scene.frame_times[i - 1];
    frame += std::abs(step - kProfileStep) <= kStepTolerance ? 1 : 2;
    const Track past = completePast(scene.ego, now);
    if (past.states.size() < 2) continue;
    const EgoNow ego = egoNow(past);
    const std::vector<EgoPath> paths = egoPaths(ego, lanes, kFollowedSeconds);
    const EgoPath& path = followedPath(paths, positionsAfter(scene.ego, now));
    const RoadAhead ahead = roadAhead(path, ego, snapshotAt(scene, now, kPastFrames));
    rows.push_back({scene.name, frame, ego.past_speeds[0], ahead});
  }
  return rows;
}

}  // namespace forge
