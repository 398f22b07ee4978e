#include "collision_forge/attack/forecast/ego_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/motion_estimate.h"

namespace forge {
namespace {

// Paths of the ego. The costs were fitted to 339 recorded scenes of nuScenes, each left out in
// turn; a path is exp(-its costs) as likely as another.
constexpr double kReachableLaneDistance =
    4.5;  // m; farther lanes, about one beside the ego's, are not driven
constexpr double kReachableLaneHeading = 1.0;  // rad between the ego and a lane
constexpr int kMaxLanes = 8;                   // nearest lanes that are followed
constexpr int kMaxPathsPerLane = 12;           // paths through the branches ahead of one lane
// Cost per metre between the path and the position after 1 s (near) or 2 s (far) at the present
// turn rate, 1/m.
constexpr double kNearDeviationCost = 1.1;
constexpr double kFarDeviationCost = 1.05;
constexpr double kBendBrakingCost = 3.3;  // s2/m; cost per m/s2 of braking that the bends need
constexpr double kTurnCost = 0.53;        // 1/rad; cost per radian of turn over the next 60 m
constexpr double kFreePathCost = 5.0;     // cost of the path that ignores lanes
constexpr double kTurnRateFading = 2.3;   // s in which the turn rate decays to 1/e off the lanes
// Limits of the quantities in RoadAhead.
constexpr double kBendReach = 80.0;        // m ahead in which bends are considered
constexpr double kBendMargin = 4.0;        // m, shortest distance assumed for braking before a bend
constexpr double kStraight = 1e-3;         // 1/m; smaller curvatures count as straight
constexpr double kMinBendBraking = -3.0;   // m/s2
constexpr double kMaxBendBraking = 6.0;    // m/s2
constexpr double kMaxBendCurvature = 0.1;  // 1/m
constexpr double kTurnReach = 60.0;        // m ahead over which the turn is measured
constexpr double kGapReach = 60.0;         // m; a vehicle farther ahead is ignored
constexpr double kMinGap = 1.5;            // m; smaller gaps count as this
constexpr double kMaxHeadway = 2.0;
constexpr double kMaxClosing = 1.0;      // 1/s
constexpr double kLaneHalfWidth = 0.9;   // m; an agent farther to the side is beside, not ahead
constexpr double kLeadMaxHeading = 1.0;  // rad between a vehicle ahead and the path

constexpr double kSameSeconds = 6.0;       // s; paths that separate later are merged
constexpr double kSameMargin = 10.0;       // m added to the distance driven in kSameSeconds
constexpr double kSameDistance = 1.0;      // m; paths farther apart are separate
constexpr double kSpeedGain = 4.0;         // m/s, mean speed gain for which paths are long enough
constexpr double kMinTurningSpeed = 1.0;   // m/s; a slower ego has no curvature
constexpr double kMaxFreeCurvature = 0.2;  // 1/m

std::size_t stepsOf(double length) {
  return static_cast<std::size_t>(std::ceil(std::max(length, 1.0) / SampledPath::kSpacing)) + 1;
}

std::vector<Vector2> evenPoints(const std::vector<Vector2>& points, double length) {
  std::vector<Vector2> even;
  even.reserve(stepsOf(length));
  std::size_t segment = 0;
  double start = 0.0;
  double span = (points[1] - points[0]).norm();
  for (std::size_t i = 0; i < stepsOf(length); ++i) {
    const double at = static_cast<double>(i) * SampledPath::kSpacing;
    while (at > start + span && segment + 2 < points.size()) {
      start += span;
      ++segment;
      span = (points[segment + 1] - points[segment]).norm();
    }
    const double ratio = (at - start) / std::max(span, 1e-9);
    even.push_back(points[segment] + ratio * (points[segment + 1] - points[segment]));
  }
  return even;
}

}  // namespace

SampledPath::SampledPath(const std::vector<Vector2>& points, double length) {
  const std::vector<Vector2> even = evenPoints(points, length);
  const std::size_t last = even.size() - 1;
  double yaw = 0.0;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vector2 chord = even[std::min(i + 2, last)] - even[i < 2 ? 0 : i - 2];
    const double chord_yaw = std::atan2(chord.y(), chord.x());
    yaw = i == 0 ? chord_yaw : yaw + angleBetween(yaw, chord_yaw);
    poses_.push_back({even[i].x(), even[i].y(), yaw});
    headings_.push_back(chord.normalized());
  }
}

SampledPath::SampledPath(const Pose2& start, double curvature, double fading, double length) {
  Pose2 pose = start;
  for (std::size_t i = 0; i < stepsOf(length); ++i) {
    poses_.push_back(pose);
    headings_.push_back(pose.heading());
    const double middle = (static_cast<double>(i) + 0.5) * kSpacing;
    const double turn = kSpacing * curvature * std::exp(-middle / fading);
    pose = compose({pose.x, pose.y, pose.yaw + 0.5 * turn}, {kSpacing, 0.0, 0.0});
    pose.yaw = poses_.back().yaw + turn;
  }
}

Pose2 SampledPath::poseAt(double arc_length, double lateral) const {
  const double position = arc_length / kSpacing;
  const double last = static_cast<double>(poses_.size() - 2);
  const auto i = static_cast<std::size_t>(std::clamp(std::floor(position), 0.0, last));
  const double ratio = position - static_cast<double>(i);
  const double turned = std::clamp(ratio, 0.0, 1.0);
  const Pose2& a = poses_[i];
  const Pose2& b = poses_[i + 1];
  const Vector2 along = headings_[i] + turned * (headings_[i + 1] - headings_[i]);
  return {a.x + ratio * (b.x - a.x) - lateral * along.y(),
          a.y + ratio * (b.y - a.y) + lateral * along.x(), a.yaw + turned * (b.yaw - a.yaw)};
}

namespace {

/// Returns the mean speed over `elapsed` s, signed along the later heading, m/s.
double speedBetween(const AgentState& earlier, const AgentState& later, double elapsed) {
  const Vector2 step = later.pose.position() - earlier.pose.position();
  return std::copysign(step.norm(), later.pose.heading().dot(step)) / elapsed;
}

/// Derives speeds and turn rate from a history shorter than kProfileStep, from the first state
/// after the last gap; a single state stands.
void deriveShortMotion(const Track& track, EgoNow& now) {
  const auto all = static_cast<int>(track.states.size());
  const AgentState& earliest = track.states[unbrokenStart(track.states, all)];
  const double elapsed = now.state.time - earliest.time;
  if (elapsed <= 0.0) return;
  now.past_speeds.fill(speedBetween(earliest, now.state, elapsed));
  now.turn_rate = angleBetween(earliest.pose.yaw, now.state.pose.yaw) / elapsed;
}

}  // namespace

EgoNow egoNow(const Track& ego) {
  if (ego.states.empty()) throw std::invalid_argument("track " + ego.id + " has no states");
  EgoNow now{ego.states.back()};
  AgentState later = now.state;
  for (std::size_t i = 0; i < now.past_speeds.size(); ++i) {
    const auto earlier = stateAt(ego, later.time - kProfileStep);
    if (!earlier && i == 0) {
      deriveShortMotion(ego, now);
      break;
    }
    if (!earlier) {
      std::fill(now.past_speeds.begin() + static_cast<std::ptrdiff_t>(i), now.past_speeds.end(),
                now.past_speeds[i - 1]);
      break;
    }
    now.past_speeds[i] = speedBetween(*earlier, later, kProfileStep);
    if (i == 0) now.turn_rate = angleBetween(earlier->pose.yaw, later.pose.yaw) / kProfileStep;
    later = *earlier;
  }
  return now;
}

namespace {

/// Returns the |curvature| over 8 m around each sample; samples near the ends take the nearest
/// value.
std::vector<double> curvatures(const std::vector<Pose2>& poses) {
  constexpr std::size_t kReach = 4;  // samples
  const std::size_t last = poses.size() - 1;
  std::vector<double> values(poses.size());
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t middle = std::clamp(i, std::min(kReach, last), last - std::min(kReach, last));
    const std::size_t from = middle - std::min(kReach, middle);
    const std::size_t to = std::min(middle + kReach, last);
    const double length = static_cast<double>(to - from) * SampledPath::kSpacing;
    values[i] = std::abs(poses[to].yaw - poses[from].yaw) / length;
  }
  return values;
}

RoadAhead bendsAhead(const SampledPath& line, const EgoNow& ego) {
  const std::vector<Pose2>& poses = line.poses();
  const std::vector<double> curvature = curvatures(poses);
  const auto indexAt = [&](double arc_length) {
    return std::min(static_cast<std::size_t>(arc_length / SampledPath::kSpacing), poses.size() - 1);
  };
  RoadAhead ahead;
  ahead.turn_rate = std::abs(ego.turn_rate);
  ahead.bend_braking = kMinBendBraking;
  const double squared_speed = ego.past_speeds[0] * ego.past_speeds[0];
  for (std::size_t i = indexAt(2.0); i <= indexAt(kBendReach); ++i) {
    const double distance = std::max(static_cast<double>(i) * SampledPath::kSpacing, kBendMargin);
    const double comfortable = kComfortableLateralAcceleration / std::max(curvature[i], kStraight);
    ahead.bend_braking =
        std::max(ahead.bend_braking, (squared_speed - comfortable) / (2.0 * distance));
  }
  ahead.bend_braking = std::min(ahead.bend_braking, kMaxBendBraking);
  ahead.bend_turn = std::abs(poses[indexAt(kTurnReach)].yaw - poses.front().yaw);
  for (std::size_t i = indexAt(10.0); i <= indexAt(20.0); ++i) {
    ahead.bend_curvature = std::max(ahead.bend_curvature, curvature[i]);
  }
  ahead.bend_curvature = std::min(ahead.bend_curvature, kMaxBendCurvature);
  return ahead;
}

/// Returns the distance from `point` to the nearest sample, m.
double distanceTo(const std::vector<Pose2>& poses, const Vector2& point) {
  double squared = std::numeric_limits<double>::infinity();
  for (const Pose2& pose : poses) {
    squared = std::min(squared, (pose.position() - point).squaredNorm());
  }
  return std::sqrt(squared);
}

/// Returns the position after `seconds` at constant speed and turn rate.
Vector2 pointAfter(const EgoNow& ego, double seconds) {
  const double yaw = ego.state.pose.yaw + 0.5 * ego.turn_rate * seconds;
  return ego.state.pose.position() +
         ego.past_speeds[0] * seconds * Vector2(std::cos(yaw), std::sin(yaw));
}

double costOf(const EgoPath& path, const EgoNow& ego) {
  const std::vector<Pose2>& poses = path.line.poses();
  return kNearDeviationCost * distanceTo(poses, pointAfter(ego, 1.0)) +
         kFarDeviationCost * distanceTo(poses, pointAfter(ego, 2.0)) +
         kBendBrakingCost * std::max(path.ahead.bend_braking, 0.0) +
         kTurnCost * path.ahead.bend_turn;
}

bool sameWay(const SampledPath& a, const SampledPath& b, double length) {
  const auto count = std::min({static_cast<std::size_t>(length / SampledPath::kSpacing),
                               a.poses().size(), b.poses().size()});
  for (std::size_t i = count; i-- > 0;) {  // from the end: paths part rather than join
    if ((a.poses()[i].position() - b.poses()[i].position()).norm() > kSameDistance) return false;
  }
  return true;
}

/// Returns the length (m) within which paths must separate to count as different.
double sameLength(const EgoNow& ego) {
  return kSameSeconds * std::max(ego.past_speeds[0], 0.0) + kSameMargin;
}

/// Returns the length of the candidate paths, m.
double reachOf(const EgoNow& ego, double horizon) {
  const double speed = std::max(ego.past_speeds[0], 0.0);
  return std::max({(speed + kSpeedGain) * horizon, sameLength(ego), kBendReach});
}

/// Sets the path's first stretch of junction lanes. `start`: arc length (m) on the first lane at
/// which the path begins.
void findJunction(const LanePath& way, double start, const LaneIndex& lanes, EgoPath& path) {
  path.junction_start = path.junction_end = std::numeric_limits<double>::infinity();
  double along = -start;
  for (const std::size_t index : way.lanes) {
    const Lane& lane = lanes.map().lanes[index];
    const double end = along + lanes.centerline(index)->length();
    const bool inside = lane.is_connector || lane.is_intersection;
    if (inside) {
      path.junction_start = std::min(path.junction_start, std::max(along, 0.0));
      path.junction_end = end;
    } else if (std::isfinite(path.junction_start)) {
      break;
    }
    along = end;
  }
}

void normalize(std::vector<EgoPath>& paths) {
  double sum = 0.0;
  for (const EgoPath& path : paths) sum += path.weight;
  for (EgoPath& path : paths) path.weight /= sum;
}

}  // namespace

std::vector<EgoPath> egoPaths(const EgoNow& ego, const LaneIndex& lanes, double horizon) {
  const double same_length = sameLength(ego);
  const double reach = reachOf(ego, horizon);
  std::vector<EgoPath> paths;
  const auto matches =
      lanes.lanesNear(ego.state.pose, kReachableLaneDistance, kReachableLaneHeading);
  const auto lane_count = std::min(matches.size(), static_cast<std::size_t>(kMaxLanes));
  for (std::size_t i = 0; i < lane_count; ++i) {
    for (const LanePath& way :
         lanes.pathsAhead(matches[i].lane, matches[i].projection.arc_length, reach,
                          static_cast<std::size_t>(kMaxPathsPerLane))) {
      EgoPath path{SampledPath(way.points, reach)};
      const bool known = std::any_of(paths.begin(), paths.end(), [&](const EgoPath& other) {
        return sameWay(path.line, other.line, same_length);
      });
      if (known) continue;
      path.on_lanes = true;
      findJunction(way, matches[i].projection.arc_length, lanes, path);
      path.ahead = bendsAhead(path.line, ego);
      path.weight = std::exp(-costOf(path, ego));
      paths.push_back(std::move(path));
    }
  }
  EgoPath free{freePath(ego, 0.0, horizon)};
  free.junction_start = free.junction_end = std::numeric_limits<double>::infinity();
  free.ahead = bendsAhead(free.line, ego);
  free.weight = std::exp(-kFreePathCost);
  paths.push_back(std::move(free));
  normalize(paths);
  return paths;
}

SampledPath freePath(const EgoNow& ego, double turn_rate_difference, double horizon) {
  const double speed = std::max(ego.past_speeds[0], kMinTurningSpeed);
  const double curvature =
      ego.past_speeds[0] < kMinTurningSpeed ? 0.0 : (ego.turn_rate + turn_rate_difference) / speed;
  return {ego.state.pose, std::clamp(curvature, -kMaxFreeCurvature, kMaxFreeCurvature),
          speed * kTurnRateFading, reachOf(ego, horizon)};
}

namespace {

struct Lead {
  double gap = kGapReach;  ///< m from the ego's front to the vehicle's rear
  double speed = 0.0;      ///< m/s along the path
};

/// Returns the agent's gap and speed if it is ahead on the path; empty if it is beside, behind or
/// crossing.
std::optional<Lead> leadOn(const std::vector<Pose2>& poses, const Track& agent, const EgoNow& ego,
                           const BoxSize& ego_size) {
  const AgentState& state = agent.states.back();
  const Vector2 position = state.pose.position();
  const auto reach = std::min(
      poses.size(), static_cast<std::size_t>((kGapReach + ego_size.length + agent.size.length) /
                                             SampledPath::kSpacing));
  std::size_t nearest = 0;
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < reach; ++i) {
    const double candidate = (poses[i].position() - position).squaredNorm();
    if (candidate < squared) {
      squared = candidate;
      nearest = i;
    }
  }
  const Pose2 local = relativeTo(poses[nearest], state.pose);
  const double half_width = 0.5 * (std::abs(std::sin(local.yaw)) * agent.size.length +
                                   std::abs(std::cos(local.yaw)) * agent.size.width);
  if (nearest == 0 || std::abs(local.y) > kLaneHalfWidth + half_width ||
      std::abs(local.yaw) > kLeadMaxHeading) {
    return std::nullopt;
  }
  const double middle = static_cast<double>(nearest) * SampledPath::kSpacing + local.x;
  const double speed =
      agent.states.size() > 1 ? state.velocity.dot(poses[nearest].heading()) : ego.past_speeds[0];
  return Lead{middle - 0.5 * (agent.size.length + ego_size.length), speed};
}

}  // namespace

RoadAhead roadAhead(const EgoPath& path, const EgoNow& ego, const Snapshot& snapshot) {
  Lead lead;
  for (const Track& agent : snapshot.agents) {
    if (!isVehicle(agent.agent_class) || !endsAt(agent, snapshot.now)) continue;
    const auto found = leadOn(path.line.poses(), agent, ego, snapshot.ego.size);
    if (found && found->gap < lead.gap) lead = *found;
  }
  RoadAhead ahead = path.ahead;
  if (lead.gap >= kGapReach) return ahead;
  const double speed = ego.past_speeds[0];
  ahead.headway = std::clamp(wishedGap(speed) / std::max(lead.gap, kMinGap), 0.0, kMaxHeadway);
  ahead.closing = std::clamp((speed - lead.speed) / std::max(lead.gap, kMinClosingGap),
                             -kMaxClosing, kMaxClosing);
  return ahead;
}

const EgoPath& followedPath(const std::vector<EgoPath>& paths, const std::vector<Vector2>& track) {
  if (paths.empty()) throw std::invalid_argument("no paths to choose from");
  const EgoPath* best = nullptr;
  double best_sum = std::numeric_limits<double>::infinity();
  for (const EgoPath& path : paths) {
    double sum = 0.0;
    for (const Vector2& point : track) sum += distanceTo(path.line.poses(), point);
    if (best == nullptr || sum < best_sum) {
      best = &path;
      best_sum = sum;
    }
  }
  return *best;
}

}  // namespace forge
