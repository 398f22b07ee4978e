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

/// Thrown if a planner test is rejected: `code` of TestPlanner.srv; what() names field and value.
struct TestRefusal : std::runtime_error {
  TestRefusal(std::uint8_t refusal_code, const std::string& message)
      : std::runtime_error(message), code(refusal_code) {}
  std::uint8_t code;
};

/// Sources of the crashes that planner_tester replays; empty fields are not given.
struct TrialSources {
  LogSource logs;         ///< for scenario files
  std::string scenarios;  ///< scenario file, for requests by line number
  std::string recording;  ///< bag, for trajectories
};

/// Builds the crash scenario for a TestPlanner request. Not thread-safe.
class TrialScenarios {
 public:
  /// `config` must outlive the object. Throws BagError if the recording cannot be read; `warnings`
  /// as for readBag().
  TrialScenarios(TrialSources sources, const Config& config, std::vector<std::string>* warnings);

  /// Returns the case for a scenario and its scene. `line` is a line number (from 1) of the
  /// scenario file, or the line itself. Throws TestRefusal.
  PlannerCase ofLine(const std::string& line);

  /// Returns the case for `trajectory` in the recording, at the frame where it starts. Sets only
  /// the scenario of the case. Throws TestRefusal.
  PlannerCase ofTrajectory(const AttackerTrajectory& trajectory, CollisionType type) const;

 private:
  std::string numberedLine(const std::string& number) const;
  /// Returns the part of a rejection message that names the first line with an attack.
  std::string firstAnswered() const;
  std::shared_ptr<const IndexedScene> sceneOf(const std::string& name);

  TrialSources sources_;
  const Config& config_;
  std::optional<IndexedScene> recording_;
  std::set<std::string> wanted_;  // names of the scenes in source_
  std::unique_ptr<SceneSource> source_;
};

}  // namespace forge
