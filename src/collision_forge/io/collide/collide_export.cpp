#include "collision_forge/io/collide/collide_export.h"
#include "collision_forge/base/files/plain_name.h"
#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/support_vehicles.h"
#include "collision_forge/io/collide/collide_frames.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace forge {
namespace {

static_assert(kCollideNowFrame == 7, "the texts say so");
constexpr EnumWord<ClipObstacle> kObstacleTexts[] = {
    {ClipObstacle::kShortHistory, "with fewer than 7 frames at 2 Hz before t0"},
    {ClipObstacle::kEgoMissing, "without the ego in a frame"},
    {ClipObstacle::kAttackerMissing, "without the attacker in one of the 7 frames before t0"},
    {ClipObstacle::kOtherType, "of a type that COLLIDE does not have"},
    {ClipObstacle::kNoCollisionFrame, "without a recorded frame at the collision"},
    {ClipObstacle::kTrajectoryEnds, "with a trajectory that ends before the collision frame"},
    {ClipObstacle::kNotCarLike, "by a motorcycle, which readers would take for a car"},
    {ClipObstacle::kUnfitName,
     "with a name of map, scene or attacker that cannot be part of a file name"},
};

namespace fs = std::filesystem;

constexpr const char* kBatch = "collision-forge";

CollideState recorded(const AgentState& state) { return {state.pose, state.velocity.norm()}; }

std::optional<CollideState> interpolated(const Track& track, double time) {
  const auto state = stateAt(track, time);
  if (!state) return std::nullopt;
  return recorded(*state);
}

/// Returns the state of an agent in an annotated frame; agents have states only there.
/// `is_resampled`: interpolates at a time that is no frame's.
std::optional<CollideState> stateInFrame(const Track& track, double time, bool is_resampled) {
  const auto found = std::find_if(
      track.states.begin(), track.states.end(),
      [=](const AgentState& state) { return std::abs(state.time - time) <= kTimeEpsilon; });
  if (found != track.states.end()) return recorded(*found);
  return is_resampled ? interpolated(track, time) : std::nullopt;
}

/// Returns the state on a trajectory, linear between points; nullopt outside its times.
std::optional<CollideState> stateOnTrajectory(const AttackerTrajectory& trajectory, double time) {
  const auto& points = trajectory.points;
  const auto after = std::find_if(points.begin(), points.end(), [=](const TrajectoryPoint& point) {
    return point.time >= time - kTimeEpsilon;
  });
  if (after == points.end()) return std::nullopt;
  if (std::abs(after->time - time) <= kTimeEpsilon) return CollideState{after->pose, after->speed};
  if (after == points.begin()) return std::nullopt;
  const TrajectoryPoint& before = *std::prev(after);
  const double ratio = (time - before.time) / (after->time - before.time);
  return CollideState{interpolate(before.pose, after->pose, ratio),
                      before.speed + ratio * (after->speed - before.speed)};
}

bool isComplete(const CollideTrack& track) {
  return std::all_of(track.frames.begin(), track.frames.end(),
                     [](const auto& frame) { return frame.has_value(); });
}

bool isEmpty(const CollideTrack& track) {
  return std::none_of(track.frames.begin(), track.frames.end(),
                      [](const auto& frame) { return frame.has_value(); });
}

bool hasLabel(const CollisionRequest& request) {
  const auto end = std::end(kCollisionTypes);
  return std::find(std::begin(kCollisionTypes), end, request.type) != end &&
         request.turning == Turning::kAttacker;
}

int placementOf(CollisionType type, const CollisionReport& report) {
  switch (type) {
    case CollisionType::kLaneChange:
      return relativeTo(report.ego_at_contact, report.attacker_at_contact).y > 0.0 ? 0 : 1;
    case CollisionType::kJunctionCrossing:
    case CollisionType::kLtap:
      return report.relative_heading < 0.0 ? 2 : 3;  // heads right, so comes from the left
    case CollisionType::kRearEnd:
      return 4;
    case CollisionType::kOppositeDirection:
      return 5;
    case CollisionType::kSideswipeSameDirection:
    case CollisionType::kAngleSameDirection:
    case CollisionType::kAngleOppositeDirection:
    case CollisionType::kAny:
      break;
  }
  throw std::invalid_argument("a collision type without a placement");
}

std::size_t frameAt(const Scene& scene, double time) {
  const auto found =
      std::find_if(scene.frame_times.begin(), scene.frame_times.end(),
                   [=](double frame) { return std::abs(frame - time) <= kTimeEpsilon; });
  if (found == scene.frame_times.end()) {
    throw std::invalid_argument("now = " + numberText(time) + " s is not a frame of " + scene.name);
  }
  return static_cast<std::size_t>(found - scene.frame_times.begin());
}

/// Builds one clip.
class ClipBuilder {
 public:
  ClipBuilder(const Scenario& scenario, const Scene& scene) : scenario_(scenario), scene_(scene) {}

  std::variant<CollideClip, ClipObstacle> build(int variant) {
    if (!hasLabel(scenario_.asked.request)) return ClipObstacle::kOtherType;
    if (const auto obstacle = setFrames()) return *obstacle;
    if (const auto obstacle = addEgoAndAttacker()) return *obstacle;
    addOthers();
    std::sort(clip_.tracks.begin(), clip_.tracks.end(),
              [](const CollideTrack& a, const CollideTrack& b) { return a.id < b.id; });
    return named(variant);
  }

 private:
  std::optional<ClipObstacle> setFrames() {
    const int ahead =
        static_cast<int>(std::lround(scenario_.asked.request.tta / kCollideFrameInterval));
    clip_.collision_frame = kCollideNowFrame + ahead;
    const std::vector<double>& frames = scene_.frame_times;
    const std::size_t now = frameAt(scene_, scenario_.asked.now);
    is_resampled_ = !areCollideFrames(frames);
    if (!is_resampled_ && now < kCollideNowFrame) return ClipObstacle::kShortHistory;
    if (ahead <= 0) return ClipObstacle::kNoCollisionFrame;
    if (is_resampled_) {
      clip_.times = collideGrid(frames, frames[now], -kCollideNowFrame, ahead);
      if (clip_.times.front() < frames.front()) return ClipObstacle::kShortHistory;
      if (clip_.times.back() > frames.back()) return ClipObstacle::kNoCollisionFrame;
      return std::nullopt;
    }
    if (now + static_cast<std::size_t>(ahead) >= frames.size()) {
      return ClipObstacle::kNoCollisionFrame;
    }
    const auto at_now = frames.begin() + static_cast<std::ptrdiff_t>(now);
    clip_.times.assign(at_now - kCollideNowFrame, at_now + ahead + 1);
    return std::nullopt;
  }

  std::optional<ClipObstacle> addEgoAndAttacker() {
    CollideTrack ego{kEgoId, {}};
    // The ego is recorded more often than agents are annotated.
    for (const double time : clip_.times) ego.frames.push_back(interpolated(scene_.ego, time));
    if (!isComplete(ego)) return ClipObstacle::kEgoMissing;

    const AttackerTrajectory& trajectory = scenario_.answer.trajectory;
    if (!isCarLike(trajectory.agent_class)) return ClipObstacle::kNotCarLike;
    const Track track = attackerPast(trajectory, scene_.agents);
    CollideTrack attacker{trajectory.attacker_id, {}};
    for (std::size_t frame = 0; frame <= kCollideNowFrame; ++frame) {
      attacker.frames.push_back(stateInFrame(track, clip_.times[frame], is_resampled_));
    }
    if (!isComplete(attacker)) return ClipObstacle::kAttackerMissing;
    for (std::size_t frame = kCollideNowFrame + 1; frame < clip_.times.size(); ++frame) {
      attacker.frames.push_back(stateOnTrajectory(trajectory, clip_.times[frame]));
    }
    if (!isComplete(attacker)) return ClipObstacle::kTrajectoryEnds;
    clip_.tracks = {ego, attacker};
    return std::nullopt;
  }

  void addOthers() {
    for (const Track& agent : scene_.agents) {
      if (!isCarLike(agent.agent_class)) continue;
      if (agent.id == scenario_.answer.trajectory.attacker_id) continue;
      CollideTrack track{agent.id, {}};
      for (const double time : clip_.times)
        track.frames.push_back(stateInFrame(agent, time, is_resampled_));
      if (!isEmpty(track)) clip_.tracks.push_back(std::move(track));
    }
  }

  std::variant<CollideClip, ClipObstacle> named(int variant) {
    const CollisionReport& report = scenario_.answer.report;
    clip_.batch = kBatch;
    clip_.city = scene_.map->location;
    clip_.scene = scene_.name;
    clip_.type = scenario_.asked.request.type;
    clip_.placement = placementOf(clip_.type, report);
    clip_.variant = variant;
    clip_.angle = std::abs(report.relative_heading);
    clip_.attacker_id = scenario_.answer.trajectory.attacker_id;
    try {
      clip_.name = fs::path(composeCollideName(clip_)).stem().string();
    } catch (const std::invalid_argument&) {
      return ClipObstacle::kUnfitName;
    }
    return std::move(clip_);
  }

  const Scenario& scenario_;
  const Scene& scene_;
  CollideClip clip_;
  bool is_resampled_ = false;
};

}  // namespace

const char* toString(ClipObstacle obstacle) { return wordOf(kObstacleTexts, obstacle); }

std::variant<CollideClip, ClipObstacle> toCollideClip(const Scenario& scenario, const Scene& scene,
                                                      int variant) {
  if (scenario.answer.status.code != StatusCode::kOk) {
    throw std::invalid_argument("a scenario without an attack has no clip");
  }
  if (scenario.answer.supports.empty()) return ClipBuilder(scenario, scene).build(variant);
  Scene supported = scene;
  addSupports(scenario.answer.supports, supported);
  return ClipBuilder(scenario, supported).build(variant);
}

std::string CollideExporter::folderIn(const std::string& directory, const std::string& split) {
  return (fs::path(directory) / "trajectory" / split).string();
}

CollideExporter::CollideExporter(const std::string& directory, const std::string& split)
    : folder_(folderIn(directory, split)) {
  fs::create_directories(folder_);
}

void CollideExporter::add(const Scenario& scenario, const Scene& scene, int variant) {
  if (scenario.answer.status.code != StatusCode::kOk) return;
  const auto result = toCollideClip(scenario, scene, variant);
  if (const auto* obstacle = std::get_if<ClipObstacle>(&result)) {
    ++obstacles_[*obstacle];
    return;
  }
  const auto& clip = std::get<CollideClip>(result);
  const std::string path = pathIn(folder_, clip.name + ".csv");
  if (!fs::exists(path)) writeCollideClip(path, clip);
  ++clips_;
}

std::string CollideExporter::complaint() const {
  int without = 0;
  std::string reasons;
  for (const auto& [obstacle, count] : obstacles_) {
    without += count;
    reasons += (reasons.empty() ? "" : ", ") + std::to_string(count) + " " + toString(obstacle);
  }
  if (without == 0) return {};
  return std::to_string(without) + " of " + std::to_string(clips_ + without) +
         " attacks have no clip of COLLIDE's layout: " + reasons;
}

}  // namespace forge
