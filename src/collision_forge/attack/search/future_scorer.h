#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// rad (0.5 degrees) kept to either end of the type's band of headings at contact.
inline constexpr double kHeadingMargin = 0.0087;

/// Score of one attacker motion over the sampled ego futures.
struct FutureScore {
  double share = 0.0;  ///< share 0..1 of futures in which all conditions hold
  /// Closeness, summed over the futures in which a condition fails and divided by the number of all
  /// futures; 0..1 per future, exp(-gap / 2 m) of the smallest gap of the boxes during the allowed
  /// times or, with a contact, exp(-heading error / 0.26 rad - time error / 0.5 s).
  double closeness = 0.0;
  /// index into the constructor's `egos` of a future in which all conditions hold; valid if share >
  /// 0
  std::size_t met = 0;
  /// attacker's box centre in the ego box's frame at the contact in future `met`; valid as `met`
  Pose2 contact;
};

/// Scores thousands of attacker motions against all ego futures, whose poses are stored by time
/// step. Conditions: the first contact with the ego is on time, of the requested type and followed
/// by an overlap of at least twice SearchOptions::overlap_margin, and no other agent is touched
/// before. Tests boxes at every step and interpolates the contact time linearly. Stricter than the
/// request by margins for overlap, heading and time, so that verify(), which is exact, agrees.
/// Ignores vehicle limits. Immutable; usable from many threads at once.
class FutureScorer {
 public:
  /// `egos`: equally likely tracks (box centres, map frame) from `now` (t0, s, scene clock) on, at
  /// least one; a track stands at its first state before it and at its last state after it; the
  /// size of the first is used for all. `agents`: other agents, may include the attackers; each
  /// counts from its first state to its last one or its first gap (kMaxGap). All are copied. Throws
  /// as request.bands().
  FutureScorer(const std::vector<const Track*>& egos, const std::vector<Track>& agents,
               const CollisionRequest& request, double now, DrivingSide driving_side,
               const AttackOptions& options);

  /// Returns the number of points that a motion needs: from t0 to the end of the time tolerance,
  /// SearchOptions::step apart.
  int steps() const { return steps_; }

  /// Scores a motion of `attacker` (its id, class and size are used) given as points at the
  /// search's time step from t0, at least steps(). `met` is `preferred` (index into `egos`) if all
  /// conditions hold there, else the middle one of the hits by index, of two the later one.
  FutureScore score(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                    std::size_t preferred = 0) const;

  /// Returns the indices into `egos` of the futures in which all conditions hold, ascending; if
  /// `first` is among them, rotated to start there.
  std::vector<std::size_t> hits(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                                std::size_t first = 0) const;

 private:
  struct Outcome;
  static std::size_t metIn(const std::vector<Outcome>& outcomes, std::size_t preferred);
  void evaluate(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                std::vector<Outcome>& outcomes) const;
  Pose2 local(const Pose2& pose) const;                     // relative to origin_'s position
  Pose2 egoAt(std::size_t step, std::size_t future) const;  // local frame
  struct Met;
  Met metAt(double contact, std::size_t future, const std::vector<TrajectoryPoint>& points) const;
  bool fitsType(double contact, std::size_t future, const Track& attacker,
                const std::vector<TrajectoryPoint>& points) const;
  /// Returns the first step before `first` at which another agent is touched, else `first`.
  int firstOther(const Track& attacker, const std::vector<TrajectoryPoint>& points,
                 int first) const;

  std::size_t count_ = 0;   // number of futures
  std::size_t padded_ = 0;  // row length of the arrays below
  int steps_ = 0;
  double step_ = 0.0;           // s
  double first_in_time_ = 0.0;  // steps between which a contact is on time
  double last_in_time_ = 0.0;
  // [step][future]
  std::vector<float> x_, y_, yaw_, cosine_, sine_;
  // [step]: circle around the ego's positions in all futures
  std::vector<Vector2> middle_;
  std::vector<double> spread_;
  // Another agent, one pose per step.
  struct Other {
    std::string id;
    BoxSize size;
    int begin = 0;  // first step at which it exists
    std::vector<Pose2> poses;
    Eigen::AlignedBox2d bounds;  // of the positions
  };
  std::vector<Other> others_;
  BoxSize ego_size_;
  CollisionType type_;
  Turning turning_;
  TypeRules rules_;
  TypeDefinition band_;
  DrivingSide driving_side_;
  double overlap_margin_;
  Pose2 origin_;
};

}  // namespace forge
