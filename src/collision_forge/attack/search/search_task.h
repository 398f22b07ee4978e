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
inline constexpr double kContactDepth = 0.25;  ///< m of overlap aimed at, so that no contact grazes
// Terms of a candidate's objective, in units of the share of futures that it hits:
inline constexpr double kClosenessWeight = 0.2;  ///< gain for FutureScore::closeness = 1
inline constexpr double kPatternWeight =
    0.3;                                     ///< cost of a contact far from its pattern; half of it
inline constexpr double kNearPattern = 0.5;  ///< this far (m) beyond the pattern's tolerance
inline constexpr double kOffLaneWeight = 1.0;   ///< cost of driving on no lane until shortly before
inline constexpr double kWrongWayWeight = 1.0;  ///< cost of driving against all lanes around

/// Free parameters of an attack along a route; the motion follows from them.
struct RouteDraft {
  std::size_t ego = 0;            ///< targeted future, an index into SearchInput::egos
  double contact = 0.0;           ///< s after t0
  Side side = Side::kLeft;        ///< touched side of the ego's box
  double heading = 0.0;           ///< rad, attacker's heading relative to the ego's
  double contact_position = 0.0;  ///< contact position along the side, see attackerOffset()
  // As in RoutePlan: s, m/s2.
  double departure = 0.0;
  double lead = 0.0;
  double late = 0.0;
  double late_acceleration = 0.0;
  double wait = 0.0;
};

/// A draft with its path.
struct DraftedWay {
  ReferencePath way;  ///< path of the attacker
  RouteDraft draft;
  std::size_t style = 0;  ///< RouteSpeed::style
};

/// One attack found by the search; within the vehicle limits.
struct FoundAttack {
  const Track* attacker = nullptr;      ///< in the snapshot
  std::vector<TrajectoryPoint> points;  ///< from t0 to a little after the requested contact
  FutureScore score;
  double off_road = 0.0;  ///< mean share 0..1 of the box off the drivable area until the contact
  /// Maximised by the search: weighted share, closeness, road use, effort, steering and miss.
  double objective = 0.0;
  double effort = 0.0;                        ///< Attack::effort
  const CollisionPattern* pattern = nullptr;  ///< the given pattern from which it came
  PatternMiss miss;                           ///< of score.contact from `pattern`
  /// The futures in which all conditions hold: score.met first, then in cyclic order. The future in
  /// which the ego comes nearest to the aim's box is preferred as first.
  std::vector<const Track*> hits;
  std::optional<DraftedWay> drafted;  ///< set for attacks along routes
  bool is_underway = false;           ///< continues Underway::planned
};

/// Paths of some attackers by id, used instead of the paths along their lanes.
using AttackerWays = std::map<std::string, ReferencePath>;

inline const AttackerWays kNoWays;

/// Motions that are searched for plausible attackers.
enum class SearchedMotion {
  kByRoutes,  ///< along a route of lanes until the manoeuvre
  kAny,       ///< any motion within the limits; only its road use is checked
};

/// An attacker that already drives its attack, at the snapshot's time.
struct Underway {
  const Snapshot& start;                 ///< snapshot at the start of the attack
  const std::vector<AgentState>& ego;    ///< observed ego since then, before its futures
  DriveState state;                      ///< replaces the state derived from its track
  std::vector<TrajectoryPoint> driven;   ///< from the attack's start to before the snapshot's time
  std::vector<TrajectoryPoint> planned;  ///< current plan from the snapshot's time on
  ReferencePath way;                     ///< its path, in addition to the paths along its lanes
  std::optional<RouteDraft> draft;       ///< of the plan, along `way`
  std::size_t style = 0;                 ///< of the plan, used with `draft`
  double effort = 0.0;                   ///< of the plan when it was made, used without `draft`
};

/// Input of a search. Holds references: the referenced objects must outlive it.
struct SearchInput {
  const Snapshot& snapshot;
  const Future& future;                           ///< other agents
  const std::vector<const Track*>& egos;          ///< equally likely ego futures, at least one
  const std::vector<CollisionPattern>& patterns;  ///< most promising first
  const CollisionRequest& request;
  const LaneIndex& lanes;
  bool exact = false;                  ///< weights the contact at the pattern as highly as a hit
  const AttackerWays& ways = kNoWays;  ///< used instead of the paths along the attackers' lanes
  SearchedMotion motion = SearchedMotion::kByRoutes;
  const Underway* underway = nullptr;  ///< set: search along routes for this one attacker

  /// Returns true if attackers are searched along routes (searchManoeuvres()).
  bool isByRoutes() const {
    return underway != nullptr || (request.crash.believable && motion == SearchedMotion::kByRoutes);
  }
};

/// Returns true if `miss` is within kExactDistance and kExactHeading.
bool isExact(const PatternMiss& miss);

}  // namespace forge
