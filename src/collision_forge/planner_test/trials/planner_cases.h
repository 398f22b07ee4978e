#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/trials/planner_case.h"

namespace forge {

/// The crashes that a run of forge test is over, by index. Thread-safe.
class PlannerCases {
 public:
  virtual ~PlannerCases() = default;
  /// One a case, all different.
  virtual const std::vector<std::string>& names() const = 0;
  /// What the cases depend on, to tell runs apart.
  virtual std::string fingerprint() const = 0;
  /// Throws what is wrong with a case that cannot be read.
  virtual PlannerCase at(std::size_t index) const = 0;
};

/// The scenes that the readable lines of scenario files are of. Throws as openScenarioCases().
std::set<std::string> readScenes(const std::vector<std::string>& paths, const InputLimits& limits);

/// The lines of scenario files, named FILE:LINE without the file's ending; the source is that name.
/// Throws std::runtime_error for a file that cannot be read or has no lines, InputError as
/// readInputLine(); a line that is none of the format, or of a scene that the source does not have,
/// is a case that cannot be read.
std::unique_ptr<PlannerCases> openScenarioCases(const std::vector<std::string>& paths,
                                                const LogSource& logs, std::size_t scenes_kept,
                                                const AnswerOptions& options,
                                                const NuScenesProgress& on_progress = {});

}  // namespace forge
