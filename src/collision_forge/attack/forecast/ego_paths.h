#pragma once

#include <array>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// m/s2 that drivers accept in bends; fitted to 339 recorded scenes of nuScenes. Also scales
/// features of networks.
inline constexpr double kComfortableLateralAcceleration = 2.5;

/// A path ahead of the ego sampled at equal steps, for fast look-up. Global map frame.
class SampledPath {
 public:
  static constexpr double kSpacing = 1.0;  ///< m of arc length between poses()

  /// Samples the first `length` m of a polyline of at least two points (m, map frame), extended
  /// straight beyond its end. Headings are averaged over 4 m.
  SampledPath(const std::vector<Vector2>& points, double length);
  /// Samples `length` m of an arc from `start` whose `curvature` (1/m, left positive) decays by 1/e
  /// per `fading` m.
  SampledPath(const Pose2& start, double curvature, double fading, double length);

  /// Returns the pose `lateral` m to the left of the path at `arc_length` (m), with the path's yaw;
  /// extended straight beyond both ends.
  Pose2 poseAt(double arc_length, double lateral) const;

  /// Returns the poses every kSpacing from arc length 0. Yaws are not wrapped: their differences
  /// are the turn of the path.
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  std::vector<Pose2> poses_;
  std::vector<Vector2> headings_;
};

/// The ego's state at t0 and its recent motion.
struct EgoNow {
  AgentState state;  ///< the newest state: box centre, global map frame
  /// m/s, as in DrivingSituation; where the history is shorter, the oldest known speed is repeated,
  /// 0 for a single state
  std::array<double, 5> past_speeds = {};
  double turn_rate = 0.0;  ///< rad/s over the last kProfileStep, counter-clockwise
};

/// Derives the ego's motion at the last state of `ego`, its track up to t0, from the poses of its
/// states. Throws std::invalid_argument if `ego` has no states.
EgoNow egoNow(const Track& ego);

/// A candidate path of the ego.
struct EgoPath {
  /// starts beside the ego: at its projection on the lane, or for the last path at its pose
  SampledPath line;
  double weight = 0.0;    ///< probability that the ego takes the path, 0..1
  bool on_lanes = false;  ///< true: along lanes; false: the path that ignores lanes
  RoadAhead ahead = {};   ///< demands of the road alone, without vehicles; see roadAhead()
  /// m along the path to its first junction, 0 if the path starts in one; infinity if there is none
  double junction_start = 0.0;
  /// m along the path to the end of that junction; infinity if there is none
  double junction_end = 0.0;
};

/// Returns the ego's candidate paths, weights summing to 1: along the lanes near it with all
/// branches, and last one path that ignores lanes and keeps the turn rate; so there is at least
/// one. The paths on lanes are sorted by lane (nearest first), not by weight. Each is long enough
/// for `horizon` s; of paths that agree over the next 6 s only the first is kept.
std::vector<EgoPath> egoPaths(const EgoNow& ego, const LaneIndex& lanes, double horizon);

/// Returns the path that ignores lanes, from the ego's pose with its turn rate plus
/// `turn_rate_difference` (rad/s), which decays; straight if the ego is slower than 1 m/s. Long
/// enough for `horizon` s.
SampledPath freePath(const EgoNow& ego, double turn_rate_difference, double horizon);

/// Returns path.ahead with the headway to the nearest vehicle ahead of the ego on the path and the
/// closing speed to it set. Vehicles without a state at t0, on another heading or more than 60 m
/// ahead are ignored; without a vehicle ahead both stay 0.
RoadAhead roadAhead(const EgoPath& path, const EgoNow& ego, const Snapshot& snapshot);

/// Returns the path with the smallest mean distance to the positions of `track` (m, map frame), the
/// first of equals. The reference points into `paths`. Throws std::invalid_argument if `paths` is
/// empty.
const EgoPath& followedPath(const std::vector<EgoPath>& paths, const std::vector<Vector2>& track);

}  // namespace forge
