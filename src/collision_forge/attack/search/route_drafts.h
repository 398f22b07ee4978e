#pragma once

#include <optional>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/contender.h"
#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// The drafts that a search along routes tries: fixed values, or values in the request's ranges if
/// it has any.
class RouteDrafts {
 public:
  /// `input` must outlive this object.
  explicit RouteDrafts(const SearchInput& input);

  /// Returns the contact positions to try (see attackerOffset()), three, ascending. The one with
  /// index kFirstPosition is tried first.
  const std::vector<double>& contactPositions() const { return contact_positions_; }
  static constexpr std::size_t kFirstPosition = 1;  ///< index into contactPositions()

  /// Returns drafts with the future, contact time, side and heading of `meeting`, contact position
  /// 0 and different departures. With late braking if the ego runs into the attacker or the request
  /// has a deceleration; with different waits if the attacker stands. `distance`: m along the route
  /// from the attacker at t0 to the meeting. May be empty if the attacker must wait too long.
  std::vector<RouteDraft> mannersFor(const RouteDraft& meeting, const Contender& contender,
                                     double distance) const;

  /// Perturbs a draft within the request's ranges. `contacts`: s after t0, range of allowed
  /// contacts; `step`: s, smallest departure and `late`. The changes are random with deviations in
  /// proportion to `scale`; 1 is the first round. A `wait` or `late` of 0 stays 0.
  void perturb(RouteDraft& draft, double scale, const Range& contacts, double step,
               Random& random) const;

 private:
  void addStandingStarts(RouteDraft draft, const Contender& contender, double distance,
                         std::vector<RouteDraft>& drafts) const;

  const SearchInput& input_;
  std::vector<double> contact_positions_;
  Range position_range_;
  std::vector<double> brakings_;     // m/s2, late braking
  std::optional<Range> wait_range_;  // s for which a standing attacker waits
};

}  // namespace forge
