#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/study/dataset/balance.h"

namespace forge {

/// What came of a clip that was tried: a line of attempts.jsonl but for the trajectory.
struct Attempt {
  SceneRequest asked;
  bool valid = false;             ///< there is a clip
  double relative_heading = 0.0;  ///< rad, at contact
  double off_road_share = 0.0;

  int length() const;  ///< of the clip, in frames
};

/// Throws as readScenarioLine(), and std::runtime_error for a line of something else than `asked`;
/// `where` says where it stands.
Attempt readAttempt(const std::string& where, const std::string& line, const SceneRequest& asked,
                    const InputLimits& limits);

/// Places of the attempts that make up a balanced data set, rising.
std::vector<std::size_t> chooseClips(const std::vector<Attempt>& attempts,
                                     const BalanceOptions& options, std::uint64_t seed);

}  // namespace forge
