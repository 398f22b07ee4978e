#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/contender.h"
#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// A contact with one of the ego's futures, and the arrival that leads to it.
struct AimedArrival {
  std::size_t ego = 0;   ///< the future
  double contact = 0.0;  ///< s from now
  double lead = 0.0;     ///< s driven straight on before the contact
  Pose2 offset;          ///< of the attacker from the ego at the contact
  Arrival arrival;       ///< its time and pose follow from these
};

/// At most `most` of the futures, as indices, spread over all of them along the ego's way: by where
/// it is at `time` (seconds, the snapshot's clock), seen from its pose now.
std::vector<std::size_t> spreadFutures(const std::vector<const Track*>& egos, const Pose2& now,
                                       double time, int most);

/// Draws arrivals for the patterns of contenders. Contacts are kept to the time that the request
/// allows for.
class ArrivalSampler {
 public:
  /// All must outlive it. `limits` are the attacker's.
  ArrivalSampler(const SearchInput& input, const AttackOptions& options,
                 const VehicleLimits& limits, Random& random);

  /// At the pattern's own box and time; at the pattern's speed or, if `steady`, at that which a
  /// steady change of speed leads to.
  AimedArrival own(const Contender& contender, const Aim& aim, bool steady) const;

  /// Anywhere along the side that the pattern touches, at any time and heading that the request
  /// allows for. `steady`: around the speed that a steady change leads to, else at any, too.
  AimedArrival wide(const Contender& contender, const Aim& aim, bool steady);

  /// Moves an arrival at random, at scale 1 about as far as a pattern may be wrong.
  void move(AimedArrival& aimed, double scale);

  /// Moves where the attacker is to be seen from the ego.
  void shift(AimedArrival& aimed, const Pose2& by) const;

  /// False when no speed within the limits brings the attacker near any of the ego's poses in time.
  bool canReach(const Contender& contender) const;

  /// The ego's box middle in a future.
  Pose2 egoAt(std::size_t ego, double seconds) const;

  /// Futures that are aimed at, spread along the way.
  const std::vector<std::size_t>& egos() const { return egos_; }
  double earliest() const { return earliest_; }  ///< s from now that a contact may be
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
  std::vector<std::size_t> egos_;  // that wide draws aim at, spread along the way
};

}  // namespace forge
