#include "collision_forge/study/evaluation/control_evaluation.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/search/judge.h"
#include "collision_forge/base/scene/find_track.h"
#include "collision_forge/io/answers/request_solver.h"

namespace forge {
namespace {

/// Returns the columns that describe the question, with a trailing comma.
std::string askedCsv(const ControlQuestion& question) {
  const SceneRequest& asked = question.asked;
  if (asked.scene.find_first_of(",\r\n") != std::string::npos) {
    throw std::runtime_error("\"" + asked.scene +
                             "\" cannot be written to a CSV file: it has commas or line ends");
  }
  std::ostringstream text;
  text << question.name << ',' << asked.scene << ',' << toString(asked.request.type) << ','
       << asked.request.tta << ',' << question.control << ',' << question.value << ',';
  return text.str();
}

}  // namespace

bool keepsControls(const AttackerTrajectory& trajectory, const CollisionRequest& request,
                   const Moment& moment, const VerificationOptions& options) {
  const CollisionReport report =
      verify(trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes}, options);
  if (!meetsRequest(report, request)) return false;
  const Track* attacker = findTrack(moment.snapshot.agents, trajectory.attacker_id);
  if (request.choice == (attacker ? AttackerChoice::kNew : AttackerChoice::kExisting)) {
    return false;
  }
  const AgentClass agent_class = attacker ? attacker->agent_class : trajectory.agent_class;
  return request.attacker_class.value_or(agent_class) == agent_class;
}

ControlEvaluator::ControlEvaluator(SceneSource& scenes, MethodMaker method,
                                   const StudyOptions& options, const EgoVehicle& ego)
    : scenes_(scenes),
      method_(std::move(method)),
      verification_(options.attack.verification),
      history_frames_(options.attack.prediction.history_frames),
      ego_(ego),
      adaptive_(options.adaptive) {}

ControlAnswer ControlEvaluator::answer(const ControlQuestion& question) const {
  const SceneRequest& asked = question.asked;
  const RequestSolver answerer(scenes_, method_, asked.request.crash, ego_, adaptive_);
  const Attack answer = answerer.answer(asked).answer;
  if (answer.status.code != StatusCode::kOk) return {answer.status.code, false};
  const auto scene = scenes_.at(asked.scene);
  const Moment moment = std::get<Moment>(momentAt(*scene, asked.now, history_frames_));
  return {StatusCode::kOk, keepsControls(answer.trajectory, asked.request, moment, verification_)};
}

std::string controlCsvHeader() { return "name,scene,type,tta,control,value,status,kept"; }

std::string toCsv(const ControlQuestion& question, const ControlAnswer& answer) {
  std::string line = askedCsv(question) + toString(answer.status) + ",";
  if (answer.status == StatusCode::kOk) line += answer.kept ? "1" : "0";
  return line;
}

std::optional<ControlAnswer> controlAnswerFromCsv(const std::string& line,
                                                  const ControlQuestion& question) {
  const std::string asked = askedCsv(question);
  if (line.compare(0, asked.size(), asked) != 0) return std::nullopt;
  const std::size_t comma = line.find(',', asked.size());
  if (comma == std::string::npos) return std::nullopt;
  const auto status = statusCodeFromString(line.substr(asked.size(), comma - asked.size()));
  if (!status) return std::nullopt;
  const ControlAnswer answer{*status, line.substr(comma + 1) == "1"};
  if (toCsv(question, answer) != line) return std::nullopt;
  return answer;
}

}  // namespace forge
