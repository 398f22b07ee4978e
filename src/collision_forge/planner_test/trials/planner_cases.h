#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/trials/planner_case.h"

namespace forge {

/// Extension point: the cases of a run of forge test, by index. testCases() calls names() and
/// fingerprint() a few times, and at() once per case on worker threads. All functions are called
/// from several threads at once and must be thread-safe and deterministic.
class PlannerCases {
 public:
  virtual ~PlannerCases() = default;
  /// Returns one unique name per case; its size is the number of cases. Must not throw.
  virtual const std::vector<std::string>& names() const = 0;
  /// Returns a text that changes if any case changes; a resumed run compares it. May throw any
  /// std::exception, which ends the run.
  virtual std::string fingerprint() const = 0;
  /// Returns the case with an index into names() (which must be below their number), with its name.
  /// Throws any std::exception if the case cannot be read; the run then records it as kUnreadable
  /// and continues.
  virtual PlannerCase at(std::size_t index) const = 0;
};

/// Returns the names of the scenes in the readable lines of scenario files. Throws
/// std::runtime_error if a file cannot be read or has no lines, InputError as readInputLine().
std::set<std::string> readScenes(const std::vector<std::string>& paths, const InputLimits& limits);

/// Opens the lines of scenario files as cases named FILE:LINE (line from 1 on), with FILE (no
/// folder, no extension) as source, in the order of `paths`. `scenes_kept`: number of scenes held
/// in memory. `options`: input limits, crash definition and history of the cases; must outlive the
/// result. The fingerprint covers the number of the lines and their texts in order, not the
/// recordings and the names of the files. `on_progress`: called while nuScenes tables are loaded.
/// Throws std::runtime_error if a file cannot be read or has no lines, if two files have the same
/// FILE, and if the source `logs` cannot be read; InputError as readInputLine(). at() throws for a
/// malformed line and for a scene missing in the source.
std::unique_ptr<PlannerCases> openScenarioCases(const std::vector<std::string>& paths,
                                                const LogSource& logs, std::size_t scenes_kept,
                                                const AnswerOptions& options,
                                                const NuScenesProgress& on_progress = {});

}  // namespace forge
