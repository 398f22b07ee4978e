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

/// Thrown when a planner test is impossible: a code of TestPlanner.srv and a message with field and
/// value.
struct TestRefusal : std::runtime_error {
  TestRefusal(std::uint8_t refusal_code, const std::string& message)
      : std::runtime_error(message), code(refusal_code) {}
  std::uint8_t code;
};

/// Sources of the crash scenarios of planner_tester; empty: not given.
struct TrialSources {
  LogSource logs;         ///< for scenario files
  std::string scenarios;  ///< path of the scenario file for requests by line number
  std::string recording;  ///< path of the bag for requests with a trajectory
};

/// Builds the crash scenarios for requests of TestPlanner.srv. Not thread-safe.
class TrialScenarios {
 public:
  /// `config` must outlive the object. Throws BagError for an unreadable recording; `warnings` as
  /// in readBag().
  TrialScenarios(TrialSources sources, const Config& config, std::vector<std::string>* warnings);

  /// Returns the case for one line of a scenario file. `line` is its number from 1 in the scenario
  /// file, or the line itself. Throws TestRefusal.
  PlannerCase ofLine(const std::string& line);

  /// Returns the case for a trajectory over the recording; t0 is the frame at which it starts. Only
  /// the scenario of the case is filled in. Throws TestRefusal.
  PlannerCase ofTrajectory(const AttackerTrajectory& trajectory, CollisionType type) const;

 private:
  std::string numberedLine(const std::string& number) const;
  /// Returns a hint for error messages: the first line of the file with a testable attack.
  std::string firstWithAttack() const;
  std::shared_ptr<const IndexedScene> sceneOf(const std::string& name);

  TrialSources sources_;
  const Config& config_;
  std::optional<IndexedScene> recording_;
  std::set<std::string> wanted_;  // names of the scenes in source_
  std::unique_ptr<SceneSource> source_;
};

}  // namespace forge
