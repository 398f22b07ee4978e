#pragma once

#include <memory>

#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/study/settings/study_config.h"
#include "properties/random_cases.h"

/// Requests at random moments of the recordings of data/embedded, and the suite's answers.
namespace forge {

const StudyConfig& embeddedConfig();

LogSource embeddedLogs();

inline const std::vector<Mode> kBothModes = {Mode::kHistory, Mode::kReplay};
inline const std::vector<Mode> kAllModes = {Mode::kHistory, Mode::kReplay, Mode::kAdaptive};

/// A request at a frame of a recording.
struct AskedMoment {
  std::shared_ptr<const IndexedScene> recording;
  double now = 0.0;  ///< s, the recording's clock
  CollisionRequest request;

  Moment moment() const;
};

/// Returns a request of random type, time and mode (one of `modes`) at a random frame; some with an
/// added attacker, some without the requirement of plausibility.
AskedMoment randomRequest(Random& random, const std::vector<Mode>& modes);

/// Returns the attack of the method `search`.
Attack answerTo(const AskedMoment& asked);

/// Solves a request of any mode as forge generate solves a line of a list. Thread-safe.
Scenario answered(const SceneRequest& asked);
inline Scenario answered(const AskedMoment& asked) {
  return answered({asked.recording->scene.name, asked.now, asked.request});
}

/// Returns the verification against the recorded motion.
CollisionReport testedReport(const AttackerTrajectory& trajectory, const AskedMoment& asked);

}  // namespace forge
