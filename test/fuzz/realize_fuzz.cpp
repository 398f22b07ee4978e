#include <collision_forge/RealizeTrajectory.h>

#include <memory>
#include <stdexcept>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/ros/messages/conversions.h"
#include "fuzz/message_in.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {
namespace {

/// Maximum length of each list: longer lists only take more time.
constexpr std::size_t kMost = 8;
constexpr std::size_t kMostStates = 200;

/// Returns options for a search with few candidates: the same code in a hundredth of the time.
const AttackOptions& quickOptions() {
  static const AttackOptions options = [] {
    AttackOptions quick = configuration().attack;
    quick.search.draws = quick.search.corrected_candidates = quick.search.kept = 4;
    quick.search.ego_poses = 2;
    quick.search.corrections = quick.search.rounds = quick.search.perturbations = 1;
    quick.search.bicycle_targets = quick.search.bicycle_rounds = 1;
    quick.search.bicycle_perturbations = 1;
    quick.route.rounds = quick.route.perturbations = 1;
    quick.route.ways = 2;
    return quick;
  }();
  return options;
}

/// Returns the lanes of the seeds' scenes.
const LaneIndex& fuzzedLanes() {
  static const LaneIndex lanes = [] {
    auto map = std::make_shared<LaneMap>();
    map->location = "embedded-right";
    map->lanes = {straightLane("east", {-30.0, 0.0}, {90.0, 0.0})};
    map->drivable_area = {rectangle(-30.0, -1.75, 90.0, 1.75)};
    return LaneIndex(map);
  }();
  return lanes;
}

void checkSize(const std::vector<Track>& tracks) {
  if (tracks.size() > kMost) throw InputError("too many tracks to fuzz with");
  for (const Track& track : tracks) {
    if (track.states.size() > kMostStates) throw InputError("too many states to fuzz with");
  }
}

/// Handles the request as the node trajectory_realizer does.
void answer(const collision_forge::RealizeTrajectory::Request& message) {
  const Config& config = configuration();
  const auto parsed = fromMessage(message.request, config.crash);
  if (const Status* refusal = std::get_if<Status>(&parsed)) throw MessageError(refusal->message);
  Snapshot snapshot = fromMessage(message.scene);
  checkSnapshot(snapshot, config.input_limits, "scene");
  checkSize(snapshot.agents);
  const CollisionRequest request = withFullId(std::get<CollisionRequest>(parsed), snapshot);
  const Status status = checkRequest(request, snapshot, config.attack.prediction);
  if (status.code != StatusCode::kOk) throw MessageError(status.message);
  Future future = fromMessage(message.future);
  checkFuture(future, config.input_limits, "future");
  checkSize({future.ego});
  checkSize(future.agents);
  checkSize(future.ego_samples);
  if (message.patterns.size() > kMost) throw InputError("too many patterns to fuzz with");
  std::vector<CollisionPattern> patterns;
  for (const auto& pattern : message.patterns) {
    patterns.push_back(fromMessage(pattern));
    checkPattern(patterns.back(), config.input_limits, "patterns");
  }
  if (message.ways.size() > kMost) throw InputError("too many ways to fuzz with");
  AttackerPaths ways;
  for (const auto& way : message.ways) {
    if (way.points.size() > 10 * kMost) throw InputError("too long a way to fuzz with");
    ways.emplace(way.attacker_id, fromMessage(way));
  }
  const Attack found =
      realize({patterns,
               {snapshot, future, request, fuzzedLanes()},
               static_cast<bool>(message.exact),
               ways,
               message.any_motion ? SearchedMotion::kAny : SearchedMotion::kByRoutes},
              quickOptions());
  if (found.status.code != StatusCode::kOk) return;
  require(found.report.verified(), "the attack is not verified");
  checkTrajectory(found.trajectory, config.input_limits, "attack");
}

}  // namespace

/// Input: a request of realize_trajectory, with scene, futures and patterns.
bool fuzzRealize(const std::string& input) {
  return isTaken("",
                 [&] { answer(messageIn<collision_forge::RealizeTrajectory::Request>(input)); });
}

}  // namespace forge
