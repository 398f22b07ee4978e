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

/// Why no planner can be tested: a code of TestPlanner.srv, and a message that names field and
/// value.
struct TestRefusal : std::runtime_error {
  TestRefusal(std::uint8_t refusal_code, const std::string& message)
      : std::runtime_error(message), code(refusal_code) {}
  std::uint8_t code;
};

/// Where the crashes that planner_tester is asked for come from; empty: not given.
struct TrialSources {
  LogSource logs;         ///< for scenario files
  std::string scenarios;  ///< scenario file whose lines are asked for by their number
  std::string recording;  ///< bag, for trajectories
};

/// Makes crash scenarios of what TestPlanner asks for. Not thread-safe.
class TrialScenarios {
 public:
  /// `config` must outlive it. Throws BagError for a recording that cannot be read; `warnings` as
  /// readBag().
  TrialScenarios(TrialSources sources, const Config& config, std::vector<std::string>* warnings);

  /// A line of a scenario file over its scene: `line` is its number, from 1 on, in the scenario
  /// file, or the line itself. Throws TestRefusal.
  PlannerCase ofLine(const std::string& line);

  /// A trajectory over the recording, at the frame where it starts; of the case the scenario alone
  /// is known. Throws TestRefusal.
  PlannerCase ofTrajectory(const AttackerTrajectory& trajectory, CollisionType type) const;

 private:
  std::string numberedLine(const std::string& number) const;
  /// For a refusal: which line of the file has an attack that can be tested.
  std::string firstAnswered() const;
  std::shared_ptr<const IndexedScene> sceneOf(const std::string& name);

  TrialSources sources_;
  const Config& config_;
  std::optional<IndexedScene> recording_;
  std::set<std::string> wanted_;  // the scenes that source_ has
  std::unique_ptr<SceneSource> source_;
};

}  // namespace forge
