#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// What an attack that is not as asked costs in a search, as a share of the futures: more than all
/// else counts, so that the others go first.
inline constexpr double kNotAsAsked = 2.0;

/// Holds attacks against what a request says of the crash beside type, time and attacker
/// (namesHow()).
class HowAsked {
 public:
  /// Both must outlive it.
  HowAsked(const SearchInput& input, const AttackOptions& options);

  /// The request says something.
  bool isNamed() const { return is_named_; }

  /// isAsAsked() in the future `ego` of SearchInput::egos; true where nothing is named. `points`:
  /// of an attacker that is underway since it set out.
  bool holds(const Track& attacker, const std::vector<TrajectoryPoint>& points, std::size_t ego);

 private:
  const SearchInput& input_;
  const VerificationOptions& options_;
  bool is_named_;
  Future judged_;  // with one of the egos; of the others what they do
};

}  // namespace forge
