#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/search/future_scorer.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/trajectory_family.h"
#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Contact and pattern of a request for an exact contact differ by at most so much. A candidate
/// also ends the search only if its contact is at most kExactDistance beyond the pattern's
/// tolerance.
inline constexpr double kExactDistance = 0.3;  ///< m
inline constexpr double kExactHeading = 0.09;  ///< rad (5 degrees)

/// Share of every vehicle limit that is used; the rest is for readers that round points.
inline constexpr double kLimitMargin = 0.998;
inline constexpr double kContactDepth = 0.25;  ///< m of overlap aimed at: no grazing contacts
// Costs and values of a candidate, as shares of the sampled futures:
inline constexpr double kClosenessWeight = 0.2;  ///< value of a near miss
inline constexpr double kPatternWeight = 0.3;  ///< cost of a contact far from its pattern; half ...
inline constexpr double kNearPattern = 0.5;    ///< ... this far (m) beyond the pattern's tolerance
inline constexpr double kOffLaneWeight = 1.0;  ///< cost of driving on no lane until shortly before
inline constexpr double kWrongWayWeight = 1.0;  ///< cost of driving against all lanes around

/// What is chosen of an attack along a route; the rest follows.
struct RouteDraft {
  std::size_t ego = 0;      ///< the future that it meets, an index into SearchInput::egos
  double contact = 0.0;     ///< s from now
  Side side = Side::kLeft;  ///< of the ego's box
  double heading = 0.0;     ///< of the attacker from the ego, rad
  double slide = 0.0;       ///< along the side, as of attackerOffset()
  // As of RoutePlan:
  double departure = 0.0;
  double lead = 0.0;
  double late = 0.0;
  double late_acceleration = 0.0;
  double wait = 0.0;
};

/// A draft with the way that it is along.
struct DraftedWay {
  ReferencePath way;
  RouteDraft draft;
  std::size_t style = 0;  ///< of kDrivingStyles, by which it is driven
};

/// One attack that the search found; drivable within the limits.
struct FoundAttack {
  const Track* attacker = nullptr;      ///< in the snapshot
  std::vector<TrajectoryPoint> points;  ///< from now to tta + tail
  FutureScore score;
  double off_road = 0.0;  ///< mean share of the box off the drivable area, to the arrival
  /// What the search maximises: share, closeness, use of the road, effort, steering and miss
  /// weighed.
  double objective = 0.0;
  double effort = 0.0;                    ///< Realization::effort
  const CollisionPattern* aim = nullptr;  ///< of those given, the one that it came from
  PatternMiss miss;                       ///< of score.contact from the aim
  /// The futures in which all conditions hold: score.met first, then round from there. Preferred is
  /// the one in which the ego comes nearest to the aim's box.
  std::vector<const Track*> hits;
  std::optional<DraftedWay> drafted;  ///< of attacks along routes
  bool is_underway = false;           ///< goes on as Underway::planned
};

/// The ways that some attackers drive along, by id, in place of those of their lanes.
using AttackerWays = std::map<std::string, ReferencePath>;

inline const AttackerWays kNoWays;

/// What motion of attackers that are to be believable is searched.
enum class SearchedMotion {
  kByRoutes,  ///< along a route of lanes until their manoeuvre
  kAny,       ///< as they can within the limits; what use that makes of the road is judged alone
};

/// An attacker that is on its way already, as it is at the snapshot's now.
struct Underway {
  const Snapshot& start;                 ///< known when it set out
  const std::vector<AgentState>& ego;    ///< what was seen of the ego since, before its futures
  DriveState state;                      ///< in place of what its track tells
  std::vector<TrajectoryPoint> driven;   ///< since it set out, to before now
  std::vector<TrajectoryPoint> planned;  ///< from now on, as it means to; as long as others
  ReferencePath way;                     ///< beside those of its lanes
  std::optional<RouteDraft> draft;       ///< of the plan, along the way
  std::size_t style = 0;                 ///< of the plan, as DraftedWay::style; used with a draft
  double effort = 0.0;                   ///< of the plan when it was made; used without a draft
};

/// What the search is given.
struct SearchInput {
  const Snapshot& snapshot;
  const Future& future;                   ///< of the others
  const std::vector<const Track*>& egos;  ///< equally likely futures of the ego, at least one
  const std::vector<CollisionPattern>& patterns;  ///< to be realised, most promising first
  const CollisionRequest& request;
  const LaneIndex& lanes;
  bool exact = false;  ///< nothing counts as much as a contact at the pattern
  const AttackerWays& ways = kNoWays;
  SearchedMotion motion = SearchedMotion::kByRoutes;
  const Underway* underway = nullptr;  ///< of a search along routes for one attacker

  bool isByRoutes() const {
    return underway != nullptr || (request.crash.believable && motion == SearchedMotion::kByRoutes);
  }
};

/// Returns true if `miss` is within kExactDistance and kExactHeading.
bool isExact(const PatternMiss& miss);

}  // namespace forge
