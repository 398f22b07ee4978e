#pragma once

#include <optional>
#include <string>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/evaluation/control_questions.h"

namespace forge {

struct ControlAnswer {
  StatusCode status = StatusCode::kOk;
  bool kept = false;  ///< with kOk: keepsControls()
};

/// Whether the attack is what a request in replay mode asks for, told anew: verify() finds it a
/// crash as asked in the recorded future, and the scene has the attacker, or not, and of the class
/// that was asked for. `moment` must have the recorded future.
bool keepsControls(const AttackerTrajectory& trajectory, const CollisionRequest& request,
                   const Moment& moment, const VerificationOptions& options);

/// Asks questions and holds what is answered against the recording. Thread-safe.
class ControlEvaluator {
 public:
  /// `scenes` must outlive it.
  ControlEvaluator(SceneSource& scenes, MethodMaker method, const StudyOptions& options,
                   const EgoVehicle& ego);

  /// Throws as RequestAnswerer::answer().
  ControlAnswer answer(const ControlQuestion& question) const;

 private:
  SceneSource& scenes_;
  MethodMaker method_;
  VerificationOptions verification_;
  int history_frames_;
  EgoVehicle ego_;
  AdaptiveOptions adaptive_;
};

/// A line a question: what was asked, the status and whether it was kept (empty without answer).
/// Both without the line's end. toCsv() throws std::runtime_error for a scene with commas or line
/// ends.
std::string controlCsvHeader();
std::string toCsv(const ControlQuestion& question, const ControlAnswer& answer);

/// The answer of a line of toCsv(); empty for a line of another question or none at all.
std::optional<ControlAnswer> controlAnswerFromCsv(const std::string& line,
                                                  const ControlQuestion& question);

}  // namespace forge
