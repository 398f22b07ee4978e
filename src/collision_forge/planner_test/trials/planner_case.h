#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// The protocol of arXiv 2510.12206 on a clip of COLLIDE: decides whether the case's attacker hits
/// an ego that a planner drives. Several threads may call the same object.
class PublishedProtocol {
 public:
  virtual ~PublishedProtocol() = default;
  /// Returns whether the attacker hits an ego that drives `ego` (middle of the box, times on the
  /// scene clock) from t0 on. Called by testPlanner() once per planner, on a worker thread. Throws
  /// std::invalid_argument if `ego` has no points.
  virtual bool isHit(const std::vector<TrajectoryPoint>& ego) const = 0;
  /// Returns whether the attacker hits the ego that idm_published drives from the clip's first
  /// frame on. Called by testPlanner() once per clip, on a worker thread.
  virtual bool isIdmHit(const PublishedIdmOptions& idm) const = 0;
};

/// A crash that planners are tested in, from any source.
struct PlannerCase {
  std::string name;    ///< of the clip, or of the scenario's line; unique
  std::string source;  ///< data set, or scenario file without folder and extension; tables have one
                       ///< row per source
  std::string scene;   ///< name of the scene; confidence intervals are clustered by it
  CollisionRequest request;  ///< request of the attack
  Status status;             ///< kOk, or why the case cannot be tested
  CrashScenario scenario;    ///< valid with kOk; `snapshot.now` always
  CollisionPattern pattern;  ///< requested pattern of the attack; valid with kOk
  double effort = 0.0;       ///< Attack::effort; valid with kOk
  std::shared_ptr<const PublishedProtocol> published;  ///< for a clip of COLLIDE, else null
};

/// Combines a line of a scenario file with its scene; the caller sets `name` and `source`. The
/// crash definition of the case's request comes from `options`, except for `believable` and
/// `limits`. A rejected request keeps its status; otherwise the status is momentAt()'s, kNoScene if
/// the scene has no frame at the line's time. `indexed`: the scene that the line names.
PlannerCase caseOfScenario(const Scenario& scenario, const IndexedScene& indexed,
                           const AnswerOptions& options);

}  // namespace forge
