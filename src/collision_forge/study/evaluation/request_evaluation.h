#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

// Evaluation of requests over logs by the strict protocol (attack/verify/strict_outcome.h) against
// the recording.

/// Returns the values of the column `method` in the rows of a request, in order, each once:
///
/// | plan's method | rows |
/// |---|---|
/// | all | "constant_velocity", "nominal" (baselines) |
/// | not a baseline | METHOD; in adaptive mode before it "adaptive" |
/// | seeded | after these "replay" |
///
/// METHOD runs in replay mode if that is the plan's mode, else in history mode. "replay" is the
/// plan's method in replay mode, omitted if that is the plan's mode.
std::vector<std::string> requestRowMethods(const EvaluationPlan& plan);

/// Returns the number of rows of RequestEvaluator::evaluate(), which is the same for every request.
std::size_t rowsPerRequest(const EvaluationPlan& plan);

/// The time of one search, or of one update step of an adaptive attacker.
struct SearchTime {
  std::string method;         ///< name of requestRowMethods(), or "adaptive, per update step"
  double milliseconds = 0.0;  ///< ms, wall-clock time
};

/// The rows of a request, in the order of requestRowMethods(), then of the seeds.
struct EvaluatedRequest {
  std::vector<ResultRow> rows;    ///< rowsPerRequest() rows
  std::vector<SearchTime> times;  ///< searches of seeded methods and steps of adaptive attackers,
                                  ///< in the order of the rows; empty for a rejected request
};

/// Evaluates requests over recorded scenes. Thread-safe; deterministic across processes.
///
/// - A seeded method runs at any confidence, by full definitions of the types, with the request's
///   seed and the following ones.
/// - Attackers of the plan's method keep the plan's limits, and must be plausible if
///   `plan.believable`. Baselines are judged by the strict limits and need not be plausible.
/// - For a request without attacker, a baseline uses the candidate (isCandidate()) with the best
///   outcome: full definitions, else angle bands, else contact; the first of equals. This is an
///   upper bound, because the choice uses the recorded future.
/// - The rows of a request that no method can solve (rejected by checkRequest(), no frame at t0,
///   the recording ends before t0 + TTA) have that status and meet no measure.
class RequestEvaluator {
 public:
  /// The runs of the plan's method that yield the rows named `name`.
  struct MethodRow {
    std::string name;  ///< column `method` of the rows
    Mode mode;         ///< in which the method runs
    int seeds;         ///< number of runs
  };

  /// `scenes` must outlive the evaluator; the other arguments are copied. Throws
  /// std::invalid_argument for a plan with another protocol than kStrict, a wrong `plan.is_seeded`,
  /// or an unknown method.
  RequestEvaluator(SceneSource& scenes, const StudyOptions& study, const PredictionModels& models,
                   const MethodRegistry& methods, const EvaluationPlan& plan);

  /// Evaluates one request; `name` is the column `name` of its rows, in results.csv the line of the
  /// request in its list, from 1. Ignores mode and crash definition of the request, which the plan
  /// and the options give. Throws the exceptions of SceneSource::at().
  EvaluatedRequest evaluate(const std::string& name, const SceneRequest& asked) const;

 private:
  SceneSource& scenes_;
  StudyOptions study_;
  EvaluationPlan plan_;
  std::vector<MethodRow> rows_;
  std::vector<MethodMaker> baselines_;
  MethodMaker method_;
};

}  // namespace forge
