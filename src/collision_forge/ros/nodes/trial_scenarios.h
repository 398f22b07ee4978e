#pragma once

#include <collision_forge/TestPlanner.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_case.h"

namespace forge {

/// Thrown when a planner test is impossible; what() names field and value. `refusal_code`: a code
/// of TestPlanner.srv (one of its own constants or a StatusCode).
struct TestRefusal : std::runtime_error {
  TestRefusal(std::uint8_t refusal_code, const std::string& message)
      : std::runtime_error(message), code(refusal_code) {}
  std::uint8_t code;  ///< for the response of TestPlanner.srv
};

/// Sources of the crash scenarios of planner_tester; an empty path: not given.
struct TrialSources {
  LogSource logs;         ///< recordings of the scenes that scenarios name
  std::string scenarios;  ///< path of the scenario file for requests by line number
  std::string recording;  ///< path of the bag for requests with a trajectory
};

/// Builds the crash scenarios for requests of TestPlanner.srv. Not thread-safe.
class TrialScenarios {
 public:
  /// Reads the recording, if one is given; the other sources are read on demand. `config` must
  /// outlive the object. Throws BagError and InputError for an unreadable recording; `warnings` as
  /// in readBag().
  TrialScenarios(TrialSources sources, const Config& config, std::vector<std::string>* warnings);

  /// Returns the case (caseOfScenario()) for one line of a scenario file: `line` is its number from
  /// 1 in TrialSources::scenarios, or the line itself, which begins with '{'. Throws TestRefusal:
  /// NO_SCENARIO for a number without a line, UNREADABLE for a line or a scene that cannot be read
  /// and a scene that `logs` lacks, and the code of the case's status if the line has no attack.
  PlannerCase ofLine(const std::string& line);

  /// Returns the case for a trajectory (scene clock, map frame) over the recording; t0 is the frame
  /// at which it starts. `type`: type of the crash. Only `scenario` and `scene` of the case are
  /// filled in. `trajectory` must have points. Throws TestRefusal: NO_RECORDING without a
  /// recording, NO_SCENE if no frame is at the trajectory's start (to 1 ms).
  PlannerCase ofTrajectory(const AttackerTrajectory& trajectory, CollisionType type) const;

 private:
  /// Returns the text of the line with this number in the scenario file. Throws TestRefusal.
  std::string numberedLine(const std::string& number) const;
  /// Returns a hint to append to an error message: the number of the file's first line with an
  /// attack, or that there is none.
  std::string firstWithAttack() const;
  /// Returns a scene of the logs. Throws TestRefusal, and as SceneSource::at().
  std::shared_ptr<const IndexedScene> sceneOf(const std::string& name);

  TrialSources sources_;
  const Config& config_;
  std::optional<IndexedScene> recording_;  // empty: not given
  std::set<std::string> wanted_;           // names of the scenes that `source_` selects
  std::unique_ptr<SceneSource> source_;    // null before the first scene
};

}  // namespace forge
