#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Penalty in the search objective for an attack that violates the request's constraints, in units
/// of the share of futures: larger than all other terms.
inline constexpr double kConstraintPenalty = 2.0;

/// Returns the values of a requested range that a search tries: the middle first, then one near
/// each end (at 20 % and 80 % of the range), so that the attack as driven may deviate a little.
std::array<double, 3> valuesTriedIn(const Range& range);

/// Tests attacks against the request's optional constraints: manoeuvre, side, impact speed,
/// overlap, conditions (hasConstraints()). Not thread-safe.
class RequestConstraints {
 public:
  /// `input` and `options` must outlive this object.
  RequestConstraints(const SearchInput& input, const AttackOptions& options);

  /// Returns true if the request has such a constraint: hasConstraints().
  bool isNamed() const { return is_named_; }

  /// Returns true if the motion `points` of `attacker` (id, class and size are used) meetsRequest()
  /// in the future with index `ego` of SearchInput::egos; always true without constraints. For an
  /// attacker underway, `points` start at the first point of its attack (Underway::driven).
  bool holds(const Track& attacker, const std::vector<TrajectoryPoint>& points, std::size_t ego);

 private:
  const SearchInput& input_;
  const VerificationOptions& options_;
  bool is_named_;
  Future judged_;  // its ego is replaced by one of the futures
};

}  // namespace forge
