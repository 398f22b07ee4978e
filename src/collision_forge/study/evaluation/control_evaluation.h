#pragma once

#include <optional>
#include <string>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/evaluation/control_questions.h"

namespace forge {

/// The result of a control question.
struct ControlAnswer {
  StatusCode status = StatusCode::kOk;
  bool kept = false;  ///< keepsControls(); meaningful only with kOk
};

/// Returns true if the attack meets all constraints of the request, checked independently of the
/// search: verify() against the recorded future finds the requested collision, and the attacker is
/// recorded or added and of the class as requested. `moment.recorded` must be set.
bool keepsControls(const AttackerTrajectory& trajectory, const CollisionRequest& request,
                   const Moment& moment, const VerificationOptions& options);

/// Runs control questions and verifies the attacks against the recording. Thread-safe.
class ControlEvaluator {
 public:
  /// `scenes` must outlive it.
  ControlEvaluator(SceneSource& scenes, MethodMaker method, const StudyOptions& options,
                   const EgoVehicle& ego);

  /// Runs one question. Throws the exceptions of RequestAnswerer::answer().
  ControlAnswer answer(const ControlQuestion& question) const;

 private:
  SceneSource& scenes_;
  MethodMaker method_;
  VerificationOptions verification_;
  int history_frames_;
  EgoVehicle ego_;
  AdaptiveOptions adaptive_;
};

// The header and one line per question of results.csv, without line ends. The column `kept` is
// empty without an attack. toCsv() throws std::runtime_error for a scene name with commas or line
// ends.
std::string controlCsvHeader();
std::string toCsv(const ControlQuestion& question, const ControlAnswer& answer);

/// Parses a line of toCsv(). Returns nullopt for a malformed line or a line of another question.
std::optional<ControlAnswer> controlAnswerFromCsv(const std::string& line,
                                                  const ControlQuestion& question);

}  // namespace forge
