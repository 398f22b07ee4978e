#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/contender.h"
#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// A contact with one predicted future of the ego, and the arrival that leads to it.
struct AimedArrival {
  std::size_t ego = 0;   ///< index of the future in SearchInput::egos
  double contact = 0.0;  ///< s after t0
  double lead = 0.0;     ///< s driven straight at arrival.speed before the contact; the arrival is
                         ///< this long before it
  Pose2 offset;          ///< attacker's box centre in the ego box's frame at the contact
  /// time and pose are derived from the other fields; speed and accelerations are free
  Arrival arrival;
};

/// Returns the indices into `egos` of at most `most` futures, the middle one of each of `most`
/// equal groups by the ego's forward distance from `now` (its box centre at t0) at `time` (s, scene
/// clock; the last state if a track ends before), shortest distance first; all if there are not
/// more than `most`.
std::vector<std::size_t> spreadFutures(const std::vector<const Track*>& egos, const Pose2& now,
                                       double time, int most);

/// Samples arrivals for the collision patterns of candidate attackers, with contacts within the
/// request's time tolerance. Not thread-safe.
class ArrivalSampler {
 public:
  /// All arguments must outlive this object. `limits` are the attacker's.
  ArrivalSampler(const SearchInput& input, const AttackOptions& options,
                 const VehicleLimits& limits, Random& random);

  /// Returns the arrival at the pattern's own pose (Aim::touching) and time, clamped to the allowed
  /// contacts, at the pattern's speed or, if `steady`, at the speed that a constant acceleration
  /// leads to.
  AimedArrival own(const Contender& contender, const Aim& aim, bool steady) const;

  /// Samples an arrival anywhere along the ego's side that the pattern touches (up to
  /// kMaxContactPosition), uniformly at any time and heading that the request allows. Speed: around
  /// the one that a constant acceleration leads to; if not `steady`, half of the draws take any
  /// speed.
  AimedArrival wide(const Contender& contender, const Aim& aim, bool steady);

  /// Perturbs an arrival at random within the allowed contacts; `scale` 1 is about the error of a
  /// pattern (1 m along, 0.6 m across, 0.2 s).
  void move(AimedArrival& aimed, double scale);

  /// Adds `by` to the attacker's pose in the ego box's frame (m, rad) and derives the arrival
  /// again.
  void shift(AimedArrival& aimed, const Pose2& by) const;

  /// Returns true if some speed within the limits brings the attacker within 6 m of the ego (box
  /// centres) at the requested or the latest contact time, in any of egos().
  bool canReach(const Contender& contender) const;

  /// Returns the ego's box centre in future `ego` (index into SearchInput::egos) at `seconds` after
  /// t0, map frame; the last pose after the end of the future.
  Pose2 egoAt(std::size_t ego, double seconds) const;

  /// Returns the indices of the futures that are targeted, see spreadFutures();
  /// SearchOptions::ego_poses at most.
  const std::vector<std::size_t>& egos() const { return egos_; }
  /// Returns the first allowed contact, s after t0: tta - (time tolerance -
  /// SearchOptions::time_margin), at least 0.3.
  double earliest() const { return earliest_; }
  /// Returns the last allowed contact, s after t0: tta + (time tolerance -
  /// SearchOptions::time_margin), at least earliest().
  double latest() const { return latest_; }

 private:
  double steadySpeed(const Contender& contender, const Pose2& target, double contact) const;
  void settle(AimedArrival& aimed) const;

  const SearchInput& input_;
  const AttackOptions& options_;
  const VehicleLimits& limits_;
  Random& random_;
  double earliest_;
  double latest_;
  std::vector<std::size_t> egos_;
};

}  // namespace forge
