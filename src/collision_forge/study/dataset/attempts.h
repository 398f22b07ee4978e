#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/study/dataset/balance.h"

namespace forge {

/// The result of one clip request: a line of attempts.jsonl (the record of all requests tried, in
/// the format of a scenario file) without the trajectory.
struct Attempt {
  SceneRequest asked;  ///< the request
  bool valid = false;  ///< a clip was found
  /// rad, attacker's yaw minus ego's at contact; unused if not `valid`.
  double relative_heading = 0.0;
  /// 0..1, mean share of the attacker's box off the drivable area from t0 to contact; unused if not
  /// `valid`.
  double off_road_share = 0.0;

  /// Returns the number of frame intervals (0.5 s) from the begin of the clip to the impact: the
  /// index of the impact's frame, from 0. TTAs are rounded to whole intervals.
  int length() const;
};

/// Parses a line of attempts.jsonl, a line of a scenario file, that belongs to the request `asked`.
/// `where` (file and line) begins the error messages. Throws the exceptions of readScenarioLine(),
/// and std::runtime_error if the line belongs to another request. `limits`: of the line's values.
Attempt readAttempt(const std::string& where, const std::string& line, const SceneRequest& asked,
                    const InputLimits& limits);

/// Returns the indices into `attempts` (ascending) of the valid attempts that form a balanced data
/// set; see chooseBalanced(), also for `seed` and the exceptions.
std::vector<std::size_t> chooseClips(const std::vector<Attempt>& attempts,
                                     const BalanceOptions& options, std::uint64_t seed);

}  // namespace forge
