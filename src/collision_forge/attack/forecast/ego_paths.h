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

  /// Samples the first `length` m (rounded up to whole kSpacing, at least 1 m) of a polyline of at
  /// least two points (m, map frame), extended straight beyond its end. Headings are averaged over
  /// the 2 m before and the 2 m after a sample, as far as the path has them.
  SampledPath(const std::vector<Vector2>& points, double length);
  /// Samples `length` m (rounded up to whole kSpacing) of an arc from `start` whose `curvature`
  /// (1/m, left positive) decays to 1/e per `fading` m.
  SampledPath(const Pose2& start, double curvature, double fading, double length);

  /// Returns the pose `lateral` m to the left of the path at `arc_length` (m), with the path's yaw;
  /// extended straight beyond both ends.
  Pose2 poseAt(double arc_length, double lateral) const;

  /// Returns the poses every kSpacing from arc length 0, the last one at or beyond `length`. Yaws
  /// are not wrapped: their differences are the turn of the path.
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  std::vector<Pose2> poses_;
  std::vector<Vector2> headings_;
};

/// The ego's state at t0 and its recent motion.
struct EgoNow {
  AgentState state;  ///< the newest state: box centre, global map frame
  /// m/s, as in DrivingSituation; where the history ends, the oldest known speed is repeated. A
  /// history shorter than kProfileStep gives its mean speed five times, a single state 0.
  std::array<double, 5> past_speeds = {};
  double turn_rate = 0.0;  ///< rad/s over the last kProfileStep (or the shorter history),
                           ///< counter-clockwise; 0 for a single state
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
  /// m along the path to its first junction (a lane with is_connector or is_intersection), 0 if the
  /// path starts in one; infinity if there is none
  double junction_start = 0.0;
  /// m along the path to the end of that junction's consecutive lanes; infinity if there is none
  double junction_end = 0.0;
};

/// Returns the ego's candidate paths, weights summing to 1: along the nearest lanes (at most 8,
/// within 4.5 m and 1 rad) with up to 12 branches each, and last freePath(); so there is at least
/// one. The paths on lanes are sorted by lane (nearest first), not by weight. The probability falls
/// with the distance of the path from the motion at the present turn rate, with the braking that
/// its bends need and with its turn. Each path is long enough for `horizon` s at 4 m/s above the
/// present speed, and at least 80 m; where the lanes end, it continues straight. If paths stay
/// within 1 m of each other over the distance of the next 6 s plus 10 m, only the first is kept.
std::vector<EgoPath> egoPaths(const EgoNow& ego, const LaneIndex& lanes, double horizon);

/// Returns the path that ignores lanes, from the ego's pose with its turn rate plus
/// `turn_rate_difference` (rad/s), which decays to 1/e in the distance that the ego drives in 2.3
/// s; |curvature| at most 0.2 1/m. Straight if the ego is slower than 1 m/s. As long as the paths
/// of egoPaths().
SampledPath freePath(const EgoNow& ego, double turn_rate_difference, double horizon);

/// Returns path.ahead with the headway to the nearest vehicle ahead of the ego on the path and the
/// closing speed to it set. Ignores vehicles without a state at t0, more than 1 rad off the path's
/// heading, with a gap above 60 m, or whose box is more than 0.9 m beside the path. Without a
/// vehicle ahead both stay 0.
RoadAhead roadAhead(const EgoPath& path, const EgoNow& ego, const Snapshot& snapshot);

/// Returns the path with the smallest mean distance from the positions of `track` (m, map frame) to
/// the nearest of its poses(); the first of equals, so the first path if `track` is empty. The
/// reference points into `paths`. Throws std::invalid_argument if `paths` is empty.
const EgoPath& followedPath(const std::vector<EgoPath>& paths, const std::vector<Vector2>& track);

}  // namespace forge
