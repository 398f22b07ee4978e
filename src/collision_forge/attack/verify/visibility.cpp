#include "collision_forge/attack/verify/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

constexpr double kSame = 1e-9;         // rad, s
constexpr double kStandsWithin = 0.5;  // m that a parked vehicle may move by errors of its track
constexpr double kSameDirection = M_PI_4;  // rad between the headings of ego and leader

/// An interval of directions, rad from a reference direction.
struct Angles {
  double low = 0.0;
  double high = 0.0;
};

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns the directions of a box that does not contain `from`, relative to `reference`.
Angles anglesOf(const OrientedBox& box, const Vector2& from, const Vector2& reference) {
  const Vector2 middle = box.center.position() - from;
  const double to_middle = std::atan2(cross(reference, middle), reference.dot(middle));
  Angles angles{to_middle, to_middle};
  for (const Vector2& corner : corners(box)) {
    const Vector2 way = corner - from;
    const double angle = to_middle + std::atan2(cross(middle, way), middle.dot(way));
    angles.low = std::min(angles.low, angle);
    angles.high = std::max(angles.high, angle);
  }
  return angles;
}

/// Distances (m) along a ray at which it enters and leaves a box; infinite if it misses the box.
struct Passage {
  double enters = std::numeric_limits<double>::infinity();
  double leaves = std::numeric_limits<double>::infinity();
};

/// Returns the passage of the ray along a unit direction.
Passage passageOf(const OrientedBox& box, const Vector2& from, const Vector2& direction) {
  const Vector2 ahead = box.center.heading();
  const Vector2 start = from - box.center.position();
  const Vector2 left(-ahead.y(), ahead.x());
  const double extents[] = {0.5 * box.size.length, 0.5 * box.size.width};
  const Vector2 axes[] = {ahead, left};
  double enters = 0.0;
  double leaves = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    const double place = start.dot(axes[i]);
    const double speed = direction.dot(axes[i]);
    if (std::abs(speed) < kSame) {
      if (std::abs(place) > extents[i]) return {};
      continue;
    }
    const double one = (-extents[i] - place) / speed;
    const double other = (extents[i] - place) / speed;
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  return enters <= leaves ? Passage{enters, leaves} : Passage{};
}

/// Returns true if the line from the eye over the roof of a nearer block leaves the head of the
/// target in view.
bool isSeenAbove(double roof, const Passage& nearer, const Block& target, double distance) {
  const auto shadow = [&](double edge) {
    return kEyeHeight + (roof - kEyeHeight) * distance / edge;
  };
  return target.height - std::max(shadow(nearer.enters), shadow(nearer.leaves)) >= kHeadHeight;
}

double unitedLength(std::vector<Angles>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const Angles& a, const Angles& b) { return a.low < b.low; });
  double length = 0.0;
  double reached = -std::numeric_limits<double>::infinity();
  for (const Angles& part : parts) {
    length += std::max(0.0, part.high - std::max(part.low, reached));
    reached = std::max(reached, part.high);
  }
  return length;
}

/// Agents that may hide the attacker at one time.
struct Agents {
  std::vector<Block> blocks;
  std::vector<const Track*> tracks;
};

Agents agentsNear(const Future& future, const std::string& attacker, double time,
                  const Vector2& from, double reach) {
  Agents agents;
  for (const Track& track : future.agents) {
    if (track.id == attacker) continue;
    const auto state = stateAt(track, time);
    if (!state) continue;
    if ((state->pose.position() - from).norm() > reach + circumradius(track.size)) continue;
    agents.blocks.push_back(blockAt(track, state->pose));
    agents.tracks.push_back(&track);
  }
  return agents;
}

std::optional<Hider> kindOf(const Track& hider, const Pose2& ego, double begin, double time,
                            double contact) {
  if (!isVehicle(hider.agent_class)) return std::nullopt;
  const auto there = stateAt(hider, time);
  const auto place = [&](double when) {
    return stateAt(hider, when).value_or(*there).pose.position();
  };
  if ((place(begin) - place(contact)).norm() <= kStandsWithin) return Hider::kParkedVehicle;
  const bool leads = std::abs(angleBetween(ego.yaw, there->pose.yaw)) <= kSameDirection;
  return leads ? std::optional(Hider::kLeader) : std::nullopt;
}

}  // namespace

Block blockAt(const Track& agent, const Pose2& pose) {
  return {boxAt(agent, pose), heightOf(agent)};
}

BoxView viewOf(const Vector2& from, const Block& target, const std::vector<Block>& others) {
  BoxView view;
  const Vector2 reference = target.box.center.position() - from;
  if (distanceToPoint(target.box, from) <= 0.0) return view;
  const Angles whole = anglesOf(target.box, from, reference);
  const double reach = reference.norm() + circumradius(target.box.size);
  std::vector<Angles> covered;
  double most = 0.0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const OrientedBox& other = others[i].box;
    const double away = (other.center.position() - from).norm();
    if (away > reach + circumradius(other.size)) continue;
    if (distanceToPoint(other, from) <= 0.0) continue;
    Angles part = anglesOf(other, from, reference);
    part = {std::max(part.low, whole.low), std::min(part.high, whole.high)};
    if (part.high - part.low <= kSame) continue;
    // If two convex shapes are apart, one is before the other on every common ray.
    const double middle = std::atan2(reference.y(), reference.x()) + 0.5 * (part.low + part.high);
    const Vector2 direction(std::cos(middle), std::sin(middle));
    const Passage passage = passageOf(other, from, direction);
    const double distance = passageOf(target.box, from, direction).enters;
    if (passage.enters >= distance) continue;
    if (isSeenAbove(others[i].height, passage, target, distance)) continue;
    covered.push_back(part);
    if (part.high - part.low > most) {
      most = part.high - part.low;
      view.coverer = i;
    }
  }
  view.visible = 1.0 - unitedLength(covered) / (whole.high - whole.low);
  return view;
}

Sight sightOf(const AttackerTrajectory& trajectory, const Future& future, double contact) {
  const double begin = trajectory.points.front().time;
  const Track* recorded = findTrack(future.agents, trajectory.attacker_id);
  Track attacker{trajectory.attacker_id, trajectory.agent_class, trajectory.size, {}};
  if (recorded) attacker.height = recorded->height;
  const auto steps = static_cast<int>(std::ceil((contact - begin) / kSightStep - kSame));
  for (int step = steps - 1; step >= 0; --step) {
    const double time = begin + step * kSightStep;
    const auto ego = stateAt(future.ego, time);
    if (!ego) continue;
    const Block target = blockAt(attacker, poseAt(trajectory, time));
    const Vector2 from = ego->pose.position();
    const double reach = (target.box.center.position() - from).norm() + circumradius(attacker.size);
    const Agents agents = agentsNear(future, trajectory.attacker_id, time, from, reach);
    const BoxView view = viewOf(from, target, agents.blocks);
    if (view.visible >= kSeenShare) continue;
    const Track& hider = *agents.tracks[*view.coverer];
    return {std::min(time + kSightStep, contact), hider.id,
            kindOf(hider, ego->pose, begin, time, contact)};
  }
  return {begin};
}

}  // namespace forge
