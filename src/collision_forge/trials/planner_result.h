#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/trials/avoidability.h"
#include "collision_forge/trials/planner_case.h"
#include "collision_forge/trials/rollout.h"

namespace forge {

/// What is kept of an Avoidability.
struct AvoidabilitySummary {
  bool is_avoidable = false;
  std::vector<EvasiveManoeuvre> from_now;  ///< those that work from now on
  EvasiveManoeuvre last =
      EvasiveManoeuvre::kKeeping;  ///< these three with is_avoidable: the witness with the
  double last_after = 0.0;         ///< latest start, s from now
  double off_road_share = 0.0;
};

/// One planner in one case; `driven` is left empty.
struct PlannerRow {
  std::string planner;
  RolloutOutcome outcome;
  /// In a clip of COLLIDE: the published protocol sees the attacker hit the ego that the planner
  /// drives to the last frame, through whom it may touch: from now on, with idm_published as
  /// publishedIdmDrive() has it.
  std::optional<bool> published_hit;
};

/// Status of a case that cannot be read: its name alone is known.
inline constexpr const char* kUnreadable = "UNREADABLE";

/// Status of a case that nobody can be driven through.
inline constexpr const char* kUnfit = "UNFIT";

/// All planners in one case.
struct PlannerTestResult {
  std::string name;
  std::string source;  ///< these five with isRead()
  std::string scene;
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;
  double now = 0.0;        ///< s, the scene's clock
  std::string status;      ///< "OK", a StatusCode, kUnreadable or kUnfit: nothing to test on
  std::string message;     ///< for people; empty with OK
  bool is_strict = false;  ///< with OK: all conditions of the strict protocol against the recording
  AvoidabilitySummary avoidability;  ///< these two with OK
  /// With OK a row a planner. Of an unfit clip idm_published alone, with `published_hit` alone:
  /// that test drives the clip from its first frame.
  std::vector<PlannerRow> rows;

  bool isTested() const { return status == "OK"; }
  bool isRead() const { return status != kUnreadable; }
};

/// A result without anything tested.
PlannerTestResult untested(const PlannerCase& one, const std::string& status,
                           const std::string& message);

/// Tells what a case is without a planner: its status and, with OK, whether it is strict and
/// avoidable. A case that checkScenario() refuses is kUnfit.
PlannerTestResult judgeCase(const PlannerCase& one, const StudyOptions& study,
                            const TrialOptions& trials);

/// Drives a planner through a case that judgeCase() finds OK. Throws std::invalid_argument for an
/// unknown planner.
PlannerRow testPlanner(const PlannerCase& one, const std::string& planner, Background background,
                       const StudyOptions& study, const TrialOptions& trials);

/// Drives every planner through the case as judgeCase() finds it; rows as PlannerTestResult has
/// them. Throws as testPlanner().
PlannerTestResult testPlanners(const PlannerCase& one, const std::vector<std::string>& planners,
                               Background background, const StudyOptions& study,
                               const TrialOptions& trials);

/// s from `now`, to the microsecond, the clock's resolution.
double fromNow(double time, double now);

}  // namespace forge
