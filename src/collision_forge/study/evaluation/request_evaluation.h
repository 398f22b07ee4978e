#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

// Requests over logs, judged by the strict protocol (attack/verify/strict_outcome.h) against the
// recording.

/// What one row a request (of seeded methods one a seed) is of: the baselines "constant_velocity"
/// and "nominal", which every plan measures beside its method, then the method; of a seeded one a
/// column of the strict protocol, and in history mode the same with the recorded future known:
/// "search_full_definitions" (or "network+search_..."), "replay_full_definitions"; in adaptive mode
/// before these two "adaptive_full_definitions", of a method without seeds "adaptive". Where the
/// attacker need not be believable there are the angle bands, too, each before the other column:
/// "search_angle_bands", "replay_angle_bands".
std::vector<std::string> requestRowMethods(const EvaluationPlan& plan);

/// Those of them that are no baselines.
std::vector<std::string> attackingRowMethods(const EvaluationPlan& plan);

/// Rows that RequestEvaluator::evaluate() gives, the same for every request.
std::size_t rowsPerRequest(const EvaluationPlan& plan);

/// How long one search took.
struct SearchTime {
  std::string method;  ///< of requestRowMethods()
  double milliseconds = 0.0;
};

/// A request's rows, in the order of requestRowMethods() and then of the seeds.
struct EvaluatedRequest {
  std::vector<ResultRow> rows;
  std::vector<SearchTime> times;  ///< one a row of a search, in their order
};

/// Evaluates requests over recorded scenes. Thread-safe; the rows of a request are the same in
/// every process.
///
/// - A seeded method is asked whatever the confidence, with the request's seed and those after it;
///   its type rules are those of the column that it is for, in whose measures alone it counts.
/// - The method's attackers keep the plan's limits and are believable if the plan says so;
/// baselines
///   are held to the strict limits and need not be believable.
/// - A baseline takes, if the request names no attacker, of all candidates (isCandidate()) the
///   first that meets the full definitions, else the angle bands, else touches the ego: an upper
///   bound, for nobody knows now which one will.
/// - Rows of a request that no method can answer (checkRequest(), no frame, a recording that ends
///   before the time asked for) have its status and meet nothing.
class RequestEvaluator {
 public:
  /// What a row of the plan's method is of.
  struct MethodRow {
    std::string name;
    TypeRules rules;
    Mode mode;
    int seeds;
  };

  /// `scenes` must outlive it. Throws std::invalid_argument for a plan of another protocol, and as
  /// MethodMaker does.
  RequestEvaluator(SceneSource& scenes, const StudyOptions& study, const Foresight& foresight,
                   const MethodRegistry& methods, const EvaluationPlan& plan);

  /// `name` is that of the rows. Throws as SceneSource::at() does.
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
