#pragma once

#include <array>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// m/s2 in bends; fitted to 339 recorded scenes of nuScenes. Also scales features of networks.
inline constexpr double kComfortableLateralAcceleration = 2.5;

/// A path ahead of the ego sampled at equal steps, for fast look-up. Global map frame.
class SampledPath {
 public:
  static constexpr double kSpacing = 1.0;  ///< m

  /// Samples the first `length` m of a polyline of at least two points, extended straight beyond
  /// its end. Headings are averaged over 4 m.
  SampledPath(const std::vector<Vector2>& points, double length);
  /// Samples an arc from `start` whose `curvature` (1/m) decays by 1/e per `fading` m.
  SampledPath(const Pose2& start, double curvature, double fading, double length);

  /// Returns the pose `lateral` m to the left of the path at `arc_length` (m), with the path's yaw;
  /// extended straight beyond both ends.
  Pose2 poseAt(double arc_length, double lateral) const;

  /// Poses every kSpacing from arc length 0. Yaws are not wrapped: their differences are the turn
  /// of the path.
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  std::vector<Pose2> poses_;
  std::vector<Vector2> headings_;
};

/// The ego's state at t0 and its recent motion.
struct EgoNow {
  AgentState state;
  std::array<double, 5> past_speeds = {};  ///< m/s, as in DrivingSituation
  double turn_rate = 0.0;                  ///< rad/s over the last kProfileStep
};

/// Derives the ego's motion from past states only. Throws std::invalid_argument if `ego` has no
/// states.
EgoNow egoNow(const Track& ego);

/// A candidate path of the ego.
struct EgoPath {
  SampledPath line;
  double weight = 0.0;          ///< probability
  bool on_lanes = false;        ///< false: the path that ignores lanes
  WayAhead ahead = {};          ///< the road alone; wayAhead() adds the vehicle ahead
  double junction_start = 0.0;  ///< m along the path to its first junction; infinity if none
  double junction_end = 0.0;    ///< m to the end of that junction; infinity if none
};

/// Returns the ego's candidate paths, weights summing to 1: along the lanes near it with all
/// branches, and last one path that ignores lanes and keeps the turn rate. Long enough for
/// `horizon` s; paths that agree over the next 6 s are merged.
std::vector<EgoPath> egoPaths(const EgoNow& ego, const LaneIndex& lanes, double horizon);

/// Returns the path that ignores lanes, for the ego's turn rate plus `turn_rate_difference`
/// (rad/s).
SampledPath freePath(const EgoNow& ego, double turn_rate_difference, double horizon);

/// Returns path.ahead with the headway to the nearest vehicle ahead of the ego on the path and the
/// closing speed to it set.
WayAhead wayAhead(const EgoPath& path, const EgoNow& ego, const Snapshot& snapshot);

/// Returns the path with the smallest mean distance to the positions of `track`, the first of
/// equals. Throws std::invalid_argument if `paths` is empty.
const EgoPath& followedPath(const std::vector<EgoPath>& paths, const std::vector<Vector2>& track);

}  // namespace forge
