#include "collision_forge/study/dataset/attempts.h"

#include <cmath>
#include <stdexcept>

#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/scenarios/request_file.h"

namespace forge {

int Attempt::length() const {
  return kCollideNowFrame +
         static_cast<int>(std::lround(asked.request.tta / kCollideFrameInterval));
}

Attempt readAttempt(const std::string& where, const std::string& line, const SceneRequest& asked,
                    const InputLimits& limits) {
  const Scenario scenario = readScenarioLine(where, line, limits);
  if (requestLine(scenario.asked) != requestLine(asked)) {
    throw std::runtime_error(where + ": belongs to the request " + requestLine(scenario.asked) +
                             " instead of " + requestLine(asked) + "; choose another --out");
  }
  const CollisionReport& report = scenario.answer.report;
  return {scenario.asked, scenario.answer.status.code == StatusCode::kOk, report.relative_heading,
          report.off_road_share};
}

std::vector<std::size_t> chooseClips(const std::vector<Attempt>& attempts,
                                     const BalanceOptions& options, std::uint64_t seed) {
  std::vector<std::size_t> valid;
  std::vector<ClipKind> kinds;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    if (!attempts[i].valid) continue;
    valid.push_back(i);
    kinds.push_back({attempts[i].asked.request.type, attempts[i].length()});
  }
  std::vector<std::size_t> chosen;
  for (const std::size_t place : chooseBalanced(kinds, options, seed)) {
    chosen.push_back(valid[place]);
  }
  return chosen;
}

}  // namespace forge
