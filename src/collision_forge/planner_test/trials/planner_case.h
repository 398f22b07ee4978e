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

/// The protocol of arXiv 2510.12206 on a clip of COLLIDE. It decides whether the case's attacker
/// hits an ego that a planner drives.
class PublishedProtocol {
 public:
  virtual ~PublishedProtocol() = default;
  /// True if the attacker hits the ego that drives `ego` from now on. Throws std::invalid_argument
  /// if `ego` has no points.
  virtual bool isHit(const std::vector<TrajectoryPoint>& ego) const = 0;
  /// True if the attacker hits the ego that the planner idm_published drives from the clip's first
  /// frame on.
  virtual bool isIdmHit(const PublishedIdmOptions& idm) const = 0;
};

/// A crash that planners are tested on, wherever it comes from.
struct PlannerCase {
  std::string name;    ///< of the clip, or of the scenario's line
  std::string source;  ///< of scenarios: the tables have a row each
  std::string scene;   ///< what the intervals are clustered by
  CollisionRequest request;
  Status status;             ///< why there is nothing to test on, where there is not
  CrashScenario scenario;    ///< with kOk only, but snapshot.now always
  CollisionPattern pattern;  ///< aimed at; with kOk only
  double effort = 0.0;       ///< Realization::effort
  std::shared_ptr<const PublishedProtocol> published;  ///< of a clip of COLLIDE, else null
};

/// A line of a scenario file over its scene. Declined answers keep their status; kNoScene where
/// the scene has no frame at its time.
PlannerCase caseOfScenario(const Scenario& scenario, const IndexedScene& indexed,
                           const AnswerOptions& options);

}  // namespace forge
