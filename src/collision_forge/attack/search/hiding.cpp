#include "collision_forge/attack/search/hiding.h"

#include <algorithm>

#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

constexpr double kTrafficStep = 0.2;  // s between the times at which others are tested
constexpr int kLeastHidden = 3;       // steps of kSightStep

RecordedTraffic trafficOf(const HidingInput& input) {
  const AttackerTrajectory& attacker = input.attacker;
  Snapshot past = input.past;
  Future future = input.future;
  const Track before = attackerPast(attacker, past.agents);
  for (auto* agents : {&past.agents, &future.agents}) {
    agents->erase(
        std::remove_if(agents->begin(), agents->end(),
                       [&](const Track& track) { return track.id == attacker.attacker_id; }),
        agents->end());
  }
  past.agents.push_back(before);
  future.agents.push_back(
      {attacker.attacker_id, attacker.agent_class, attacker.size, toStates(attacker.points)});
  const double end = std::max(future.ego.states.back().time, attacker.points.back().time);
  return {past, future, end - past.now, kTrafficStep};
}

}  // namespace

AttackerTrajectory standingVehicle(const std::string& id, const AddedKind& kind, const Pose2& pose,
                                   const HidingInput& input) {
  AttackerTrajectory motion{id, kind.agent_class, {kind.length, kind.width}, {}};
  for (const AgentState& frame : input.past.ego.states) {
    motion.past.push_back({frame.time, pose, Vector2::Zero()});
  }
  const double begin = input.attacker.points.front().time;
  const double end = input.attacker.points.back().time;
  for (double time = begin; time < end + kFrameInterval; time += kFrameInterval) {
    motion.points.push_back({time, pose, 0.0, 0.0, 0.0});
  }
  return motion;
}

HidingSearch::HidingSearch(const HidingInput& input) : input_(input), traffic_(trafficOf(input)) {
  observe();
}

void HidingSearch::observe() {
  const std::string& id = input_.attacker.attacker_id;
  Track attacker{id, input_.attacker.agent_class, input_.attacker.size, {}};
  if (const Track* recorded = findTrack(input_.future.agents, id)) {
    attacker.height = recorded->height;
  }
  for (double time = input_.attacker.points.front().time; time < input_.contact - 1e-9;
       time += kSightStep) {
    const auto ego = stateAt(input_.future.ego, time);
    if (!ego) continue;
    Look look{time, ego->pose.position(), blockAt(attacker, poseAt(input_.attacker, time)), {}};
    for (const Track& agent : input_.future.agents) {
      const auto state = stateAt(agent, time);
      if (agent.id != id && state) look.others.push_back(blockAt(agent, state->pose));
    }
    looks_.push_back(std::move(look));
  }
}

Hiding HidingSearch::hidingBy(const AddBlocks& add) const {
  const auto isHidden = [&](const Look& look) {
    std::vector<Block> others = look.others;
    add(look.time, others);
    return viewOf(look.from, look.target, others).visible < kSeenShare;
  };
  auto seen = looks_.end();
  while (seen != looks_.begin() && !isHidden(*std::prev(seen))) --seen;
  auto first = seen;
  while (first != looks_.begin() && isHidden(*std::prev(first))) --first;
  const double seen_from = seen == looks_.end() ? input_.contact : seen->time;
  return {input_.contact - seen_from, static_cast<int>(seen - first)};
}

bool HidingSearch::isInRange(const Hiding& hiding) const {
  return hiding.hidden >= kLeastHidden && hiding.visible_for >= input_.visible_for.min &&
         hiding.visible_for <= input_.visible_for.max;
}

bool HidingSearch::mayHide(const Block& block) const {
  return std::any_of(looks_.begin(), looks_.end(), [&](const Look& look) {
    const double before = input_.contact - look.time;
    const bool is_near_sight =
        before >= input_.visible_for.min && before <= input_.visible_for.max + 2.0 * kSightStep;
    return is_near_sight && viewOf(look.from, look.target, {block}).visible < kSeenShare;
  });
}

bool HidingSearch::isOnRoad(const OrientedBox& box) const {
  const auto isRoad = [&](const Vector2& point) {
    return input_.lanes.drivable().contains(point) && !input_.lanes.walkways().contains(point);
  };
  const auto outline = corners(box);
  const auto inside = samplePointsOf(box);
  return std::all_of(outline.begin(), outline.end(), isRoad) &&
         std::all_of(inside.begin(), inside.end(), isRoad);
}

std::string HidingSearch::newId(const std::string& prefix, std::size_t number) const {
  std::string id;
  do {
    id = prefix + "-" + std::to_string(++number);
  } while (findTrack(input_.past.agents, id) || findTrack(input_.future.agents, id));
  return id;
}

}  // namespace forge
