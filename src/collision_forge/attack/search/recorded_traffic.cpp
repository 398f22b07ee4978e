#include "collision_forge/attack/search/recorded_traffic.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

/// Returns true if the line between two points crosses the box.
bool crosses(const OrientedBox& box, const Vector2& from, const Vector2& to) {
  const Pose2 a = relativeTo(box.center, {from.x(), from.y(), 0.0});
  const Pose2 b = relativeTo(box.center, {to.x(), to.y(), 0.0});
  double begin = 0.0;
  double end = 1.0;
  const auto clip = [&](double start, double span, double half) {
    if (std::abs(span) < 1e-9) return std::abs(start) <= half;
    const double one = (-half - start) / span;
    const double other = (half - start) / span;
    begin = std::max(begin, std::min(one, other));
    end = std::min(end, std::max(one, other));
    return begin <= end;
  };
  return clip(a.x, b.x - a.x, 0.5 * box.size.length) && clip(a.y, b.y - a.y, 0.5 * box.size.width);
}

}  // namespace

RecordedTraffic::RecordedTraffic(const Snapshot& past, const Future& future, double end,
                                 double interval)
    : interval_(interval) {
  const double begin = past.ego.states.empty() ? past.now : past.ego.states.front().time;
  first_ = -static_cast<int>(std::ceil((past.now - begin) / interval - 1e-6));
  const int last = static_cast<int>(std::ceil(end / interval));
  bodies_.resize(static_cast<std::size_t>(last - first_ + 1));
  const auto add = [&](const Track& track, int from, int to, bool is_ego) {
    if (track.states.empty()) return;
    const bool hides_others =
        isCarLike(track.agent_class) || track.agent_class == AgentClass::kTrailer;
    const double radius = circumradius(track.size);
    const auto instantOf = [&](double time) { return (time - past.now) / interval; };
    // The first instant stands for the first frame, which is less than an interval later.
    if (track.states.front().time > begin) {
      from =
          std::max(from, static_cast<int>(std::ceil(instantOf(track.states.front().time) - 1e-6)));
    }
    to = std::min(to, static_cast<int>(std::floor(instantOf(track.states.back().time) + 1e-6)));
    for (int instant = from; instant <= to; ++instant) {
      const double time = std::clamp(past.now + instant * interval, track.states.front().time,
                                     track.states.back().time);
      const auto state = stateAt(track, time);
      if (!state) continue;
      bodies_[static_cast<std::size_t>(instant - first_)].push_back(
          {boxAt(track, state->pose), radius, is_ego, hides_others});
    }
  };
  add(past.ego, first_, 0, true);
  for (const Track& agent : past.agents) add(agent, first_, 0, false);
  for (const Track& agent : future.agents) add(agent, 1, last, false);
}

const std::vector<RecordedTraffic::Body>* RecordedTraffic::at(int instant) const {
  if (instant < first_ || instant > lastInstant()) return nullptr;
  return &bodies_[static_cast<std::size_t>(instant - first_)];
}

const RecordedTraffic::Body* RecordedTraffic::egoOf(const std::vector<Body>* bodies) {
  return bodies && !bodies->empty() && bodies->front().is_ego ? &bodies->front() : nullptr;
}

bool RecordedTraffic::touches(const Pose2& pose, const BoxSize& size, int instant,
                              double clearance) const {
  const std::vector<Body>* bodies = at(instant);
  if (!bodies) return false;
  const OrientedBox box = shrunk({pose, size}, -clearance);
  const double reach = circumradius(box.size);
  const Vector2 middle = pose.position();
  return std::any_of(bodies->begin(), bodies->end(), [&](const Body& body) {
    const double near = reach + body.radius;
    return (body.box.center.position() - middle).squaredNorm() < near * near &&
           overlaps(box, body.box);
  });
}

bool RecordedTraffic::hides(const Vector2& place, int instant) const {
  const std::vector<Body>* bodies = at(instant);
  const Body* ego = egoOf(bodies);
  if (!ego) return false;
  const Vector2 from = ego->box.center.position();
  return std::any_of(bodies->begin(), bodies->end(), [&](const Body& body) {
    return !body.is_ego && body.hides_others && crosses(body.box, from, place);
  });
}

std::optional<double> RecordedTraffic::distanceToEgo(const Vector2& place, int instant) const {
  const Body* ego = egoOf(at(instant));
  if (!ego) return std::nullopt;
  return (ego->box.center.position() - place).norm();
}

}  // namespace forge
