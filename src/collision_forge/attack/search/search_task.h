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

/// Largest differences between contact and pattern if a request asks for an exact contact. Such a
/// search ends early only with a contact at most kExactDistance beyond the pattern's tolerance.
inline constexpr double kExactDistance = 0.3;  ///< m
inline constexpr double kExactHeading = 0.09;  ///< rad (5 degrees)

/// Share of every vehicle limit that is used: programs that round the points of a trajectory must
/// not find a violation.
inline constexpr double kLimitMargin = 0.998;
/// m of overlap at the requested contact that arrivals aim at, so that no contact grazes
inline constexpr double kContactDepth = 0.25;
// Terms of a candidate's objective, in units of the share of futures that it hits:
inline constexpr double kClosenessWeight = 0.2;  ///< gain for FutureScore::closeness = 1
/// cost of a contact far from its pattern; half of it at kNearPattern
inline constexpr double kPatternWeight = 0.3;
/// m between contact and pattern, beyond the pattern's tolerance
inline constexpr double kNearPattern = 0.5;
inline constexpr double kOffLaneWeight = 1.0;   ///< cost of driving on no lane until shortly before
inline constexpr double kWrongWayWeight = 1.0;  ///< cost of driving against all lanes around

/// Free parameters of an attack along a route; the motion follows from them.
struct RouteDraft {
  std::size_t ego = 0;      ///< targeted future, an index into SearchInput::egos
  double contact = 0.0;     ///< s after t0
  Side side = Side::kLeft;  ///< touched side of the ego's box
  double heading = 0.0;     ///< rad, attacker's heading minus the ego's at the contact, (-pi, pi]
  double contact_position = 0.0;  ///< share of half the side from its middle, see attackerOffset()
  /// This and the next four fields: as the fields of RoutePlan of the same names (s, m/s2).
  double departure = 0.0;
  double lead = 0.0;
  double late = 0.0;
  double late_acceleration = 0.0;
  double wait = 0.0;
};

/// A draft with the path along which it is driven.
struct DraftedPath {
  ReferencePath way;  ///< path of the attacker's box centre
  RouteDraft draft;
  std::size_t style = 0;  ///< RouteSpeed::style
};

/// One attack found by the search; within the vehicle limits unless `is_underway`.
struct FoundAttack {
  const Track* attacker = nullptr;  ///< its track in SearchInput::snapshot
  /// from t0 to SearchOptions::tail after the requested contact or, if that is later, the end of
  /// the time tolerance, SearchOptions::step apart; the current plan as it is
  std::vector<TrajectoryPoint> points;
  FutureScore score;      ///< over SearchInput::egos
  double off_road = 0.0;  ///< mean share 0..1 of the box off the drivable area until the contact
                          ///< (any motion: the requested one)
  /// Value that the search maximises, in shares of the futures: score.share plus kClosenessWeight
  /// times the closeness, minus costs of the miss, road use, effort, steering and
  /// kConstraintPenalty.
  double objective = 0.0;
  double effort = 0.0;  ///< Attack::effort; 0 for any motion
  /// the pattern of SearchInput::patterns from which it came
  const CollisionPattern* pattern = nullptr;
  PatternMiss miss;  ///< difference of score.contact from `pattern`; valid if score.share > 0
  /// The futures of SearchInput::egos in which all conditions hold: score.met first, then in cyclic
  /// order. The future in which the ego comes nearest to the aim's box is preferred as first.
  std::vector<const Track*> hits;
  /// set for attacks along routes, else empty; times of the draft in s after t0. For a current plan
  /// without a draft, the contact alone is set.
  std::optional<DraftedPath> drafted;
  bool is_underway = false;  ///< true: the attack continues Underway::planned
};

/// Paths of some attackers by id, used instead of the paths along their lanes.
using AttackerPaths = std::map<std::string, ReferencePath>;

inline const AttackerPaths kNoPaths;  ///< Empty: no attacker has a path of its own

/// Motions that are searched for plausible attackers.
enum class SearchedMotion {
  kByRoutes,  ///< along a route of lanes until the manoeuvre
  kAny,       ///< any motion within the limits; only its road use is checked
};

/// An attacker that already drives its attack, at t0 of SearchInput::snapshot. Holds references:
/// the referenced objects must outlive it.
struct Underway {
  const Snapshot& start;  ///< snapshot at the start of the attack
  /// observed ego (box centres) from that start to before its futures
  const std::vector<AgentState>& ego;
  DriveState state;                      ///< state at t0; replaces the state derived from its track
  std::vector<TrajectoryPoint> driven;   ///< from the attack's start to before t0
  std::vector<TrajectoryPoint> planned;  ///< current plan from t0 on
  ReferencePath way;  ///< path of the plan, in addition to the paths along its lanes
  /// of the plan, along `way`, times in s after t0; empty if the plan was not made from a draft
  std::optional<RouteDraft> draft;
  std::size_t style = 0;  ///< RouteSpeed::style of the plan, used with `draft`
  double effort = 0.0;    ///< Attack::effort of the plan when it was made, used without `draft`
};

/// Input of a search. Holds references: the referenced objects must outlive it.
struct SearchInput {
  const Snapshot& snapshot;                       ///< frames up to t0, with the attackers
  const Future& future;                           ///< other agents from t0 on; its ego is not used
  const std::vector<const Track*>& egos;          ///< equally likely ego futures, at least one
  const std::vector<CollisionPattern>& patterns;  ///< most promising first
  const CollisionRequest& request;
  const LaneIndex& lanes;
  /// true: prefers contacts at the pattern; only an exact one (isExact()) ends the search early
  bool exact = false;
  const AttackerPaths& ways = kNoPaths;  ///< used instead of the paths along the attackers' lanes
  SearchedMotion motion = SearchedMotion::kByRoutes;  ///< for plausible attackers only
  const Underway* underway = nullptr;  ///< set: search along routes for this one attacker

  /// Returns true if attackers are searched along routes (searchManoeuvres()).
  bool isByRoutes() const {
    return underway != nullptr || (request.crash.believable && motion == SearchedMotion::kByRoutes);
  }
};

/// Returns true if `miss` is within kExactDistance and kExactHeading.
bool isExact(const PatternMiss& miss);

}  // namespace forge
