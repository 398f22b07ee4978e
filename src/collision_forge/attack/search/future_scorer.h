#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// rad (0.5 degrees) kept to either end of the band of headings of the type.
inline constexpr double kHeadingMargin = 0.0087;

/// How one motion of an attacker fares against the sampled futures of the ego.
struct FutureScore {
  double share = 0.0;      ///< of the futures in which all conditions hold, [0, 1]
  double closeness = 0.0;  ///< of the other futures, how near they came to it, mean, [0, 1]
  // With a share above 0:
  std::size_t met = 0;  ///< one of the futures in which all conditions hold, as index
  Pose2 contact;        ///< the attacker seen from the ego at the contact there
};

/// Scores thousands of motions of attackers: the poses of all futures are laid out by time step.
/// Contact is that of the whole boxes, looked for at the steps and told between them linearly; they
/// have to come to overlap by twice SearchOptions::overlap_margin, and bands and times are narrowed
/// by the other margins. What is exact is verify(). Limits are not looked at.
/// Immutable.
class FutureScorer {
 public:
  /// `egos` are equally likely tracks from now on; where one ends before tta + time tolerance, it
  /// stays there. `agents` may hold the attackers.
  FutureScorer(const std::vector<const Track*>& egos, const std::vector<Track>& agents,
               const CollisionRequest& request, double now, DrivingSide driving_side,
               const AttackOptions& options);

  /// Motions need not be looked at longer than this: points from now to the end of the tolerance.
  int steps() const { return steps_; }

  /// `points` every SearchOptions::step from now, at least steps().
  /// `met` is `preferred` if all conditions hold there, else the middle one of those in which they
  /// do.
  FutureScore score(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                    std::size_t preferred = 0) const;

  /// The futures in which all conditions hold, as indices into `egos`: `first` first if it is one
  /// of them, then round from there.
  std::vector<std::size_t> hits(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                                std::size_t first = 0) const;

 private:
  struct Outcome;
  static std::size_t metIn(const std::vector<Outcome>& outcomes, std::size_t preferred);
  void evaluate(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                std::vector<Outcome>& outcomes) const;
  Pose2 local(const Pose2& pose) const;                     // seen from origin_'s position
  Pose2 egoAt(std::size_t step, std::size_t future) const;  // local
  struct Met;
  Met metAt(double contact, std::size_t future, const std::vector<TrajectoryPoint>& points) const;
  bool fitsType(double contact, std::size_t future, const Track& attacker,
                const std::vector<TrajectoryPoint>& points) const;
  /// The step before `first` at which somebody else is touched, or else `first`.
  int firstOther(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                 int first) const;

  std::size_t count_ = 0;   // futures
  std::size_t padded_ = 0;  // a row of the arrays below
  int steps_ = 0;
  double step_ = 0.0;           // s
  double first_in_time_ = 0.0;  // steps between which contact is on time
  double last_in_time_ = 0.0;
  // One row a step, one entry a future.
  std::vector<float> x_, y_, yaw_, cosine_, sine_;
  // One entry a step: a circle around all futures' positions.
  std::vector<Vector2> middle_;
  std::vector<double> spread_;
  // One vector of states (one a step) for each other agent that may be met.
  struct Other {
    std::string id;
    BoxSize size;
    int begin = 0;  // steps at which it is there
    std::vector<Pose2> poses;
  };
  std::vector<Other> others_;
  BoxSize ego_size_;
  CollisionType type_;
  TypeRules rules_;
  TypeDefinition band_;
  DrivingSide driving_side_;
  double overlap_margin_;
  Pose2 origin_;
};

}  // namespace forge
