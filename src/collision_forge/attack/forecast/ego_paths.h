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

/// A line ahead of the ego in even steps, for fast look-up. Global map frame.
class SampledPath {
 public:
  static constexpr double kSpacing = 1.0;  ///< metres

  /// The first `length` metres of a line (straight on beyond its end), headings over 4 m.
  SampledPath(const std::vector<Vector2>& points, double length);
  /// An arc from `start` whose curvature fades by 1/e over `fading` metres.
  SampledPath(const Pose2& start, double curvature, double fading, double length);

  /// `lateral` metres left of the path at an arc length; straight on beyond both ends. Yaw is the
  /// path's.
  Pose2 poseAt(double arc_length, double lateral) const;

  /// Even steps of kSpacing, the first at arc length 0. Yaws are not wrapped: their differences
  /// tell how far the path turns.
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  std::vector<Pose2> poses_;
  std::vector<Vector2> headings_;
};

/// The ego's motion as its newest states tell it.
struct EgoNow {
  AgentState state;
  std::array<double, 5> past_speeds = {};  ///< as DrivingSituation
  double turn_rate = 0.0;                  ///< rad/s over the last kProfileStep
};

/// Looks at the past only. Throws std::invalid_argument for a track without states.
EgoNow egoNow(const Track& ego);

/// A way that the ego may take.
struct EgoPath {
  SampledPath line;
  double weight = 0.0;  ///< probability
  bool on_lanes = false;
  WayAhead ahead = {};          ///< but for the vehicle ahead
  double junction_start = 0.0;  ///< metres to the first connector or intersection on it
  double junction_end = 0.0;    ///< metres to where that one ends; none: both are infinite
};

/// The ways that the ego may take: along the lanes near it, with all branches, and free of lanes on
/// with its turn rate (the last entry). Long enough for `horizon` seconds; ways that are the same
/// for the next 6 s come once.
std::vector<EgoPath> egoPaths(const EgoNow& ego, const LaneIndex& lanes, double horizon);

/// The free way with `turn_rate_difference` (rad/s) added to the ego's turn rate.
SampledPath freePath(const EgoNow& ego, double turn_rate_difference, double horizon);

/// The path's WayAhead with the vehicle ahead of the ego on it.
WayAhead wayAhead(const EgoPath& path, const EgoNow& ego, const Snapshot& snapshot);

/// The path that a track followed: that of the smallest mean distance, the first of equals.
const EgoPath& followedPath(const std::vector<EgoPath>& paths, const std::vector<Vector2>& track);

}  // namespace forge
