#pragma once

#include <memory>

#include "collision_forge/attack/realizer.h"
#include "collision_forge/scene/moment.h"
#include "collision_forge/settings/config.h"
#include "properties/random_cases.h"

/// Requests at random moments of the recordings of data/embedded, and the suite's answers.
namespace forge {

const Config& embeddedConfig();

/// A request at a frame of a recording.
struct AskedMoment {
  std::shared_ptr<const IndexedScene> recording;
  double now = 0.0;  ///< s, the recording's clock
  CollisionRequest request;

  Moment moment() const;
};

/// Of any type and time; some by vehicles that are added, some not believable. Of those modes.
AskedMoment randomRequest(Random& random, const std::vector<Mode>& modes);

/// Of the method `search`, that knows nothing of the recording.
Realization answerTo(const AskedMoment& asked);

/// verify() against what was recorded.
CollisionReport testedReport(const AttackerTrajectory& trajectory, const AskedMoment& asked);

}  // namespace forge
