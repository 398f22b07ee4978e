#include "collision_forge/ros/attack_finder.h"

#include <cmath>

#include "collision_forge/attack/alternatives.h"
#include "collision_forge/attack/pattern_predictor.h"
#include "collision_forge/attack/request_check.h"
#include "collision_forge/batch/printable.h"
#include "collision_forge/ros/bag_reader.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/marker_parts.h"
#include "collision_forge/ros/recorded_attack.h"
#include "collision_forge/ros/report_text.h"
#include "collision_forge/scene/number_words.h"

namespace forge {
namespace {

/// Nobody who is there attacks as asked along a route, and the services know of no others: a new
/// vehicle may, or somebody by any other motion.
bool mayBeAnsweredHere(const Status& status, const CollisionRequest& request) {
  if (!request.crash.believable) return false;
  return status.code == StatusCode::kNoCandidate ||
         status.code == StatusCode::kNoAttackWithinLimits ||
         status.code == StatusCode::kNotBelievable || status.code == StatusCode::kLowConfidence;
}

void setAlternatives(const std::vector<Realization>& found, const std::string& method, double now,
                     collision_forge::CollisionAnswer& answer) {
  for (const Realization& alternative : found) {
    answer.alternatives.push_back(toMessage(alternative, method, now));
  }
}

}  // namespace

AttackFinder::AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           const Config& config)
    : config_(config),
      methods_(loadMethods(config)),
      foresight_(loadForesight(config)),
      default_method_(forge::defaultMethod(foresight_.network != nullptr)),
      map_(node, config.input_limits),
      search_(node, config.live.answer_within) {
  loadRecording(private_node.param<std::string>("recording", ""));
}

void AttackFinder::loadRecording(const std::string& path) {
  if (path.empty()) return;
  std::vector<std::string> warnings;
  try {
    const auto attack = readRecordedAttack(path);
    if (attack) attack_in_recording_ = refusalOf(*attack, path);
    recording_ = readBag(path, config_, &warnings);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("no replay mode: " << printable(error.what()));
  }
  for (const std::string& warning : warnings) ROS_WARN_STREAM(printable(path + ": " + warning));
}

collision_forge::CollisionAnswer AttackFinder::answer(
    const collision_forge::SceneSnapshot& scene, const collision_forge::CollisionRequest& asked,
    const std::string& method) const {
  collision_forge::CollisionAnswer answer;
  answer.collision_type = asked.collision_type;
  answer.tta = asked.tta;
  Status status = find(method.empty() ? default_method_ : method, scene, asked, answer);
  if (status.code == StatusCode::kOk) status = checkContact(answer.attack.report);
  answer.code = static_cast<std::uint8_t>(status.code);
  answer.message = status.message;
  if (status.code == StatusCode::kOk) {
    answer.summary = summaryOf(answer.attack);
  } else {
    answer.attack = {};
  }
  return answer;
}

Status AttackFinder::find(const std::string& method, const collision_forge::SceneSnapshot& scene,
                          collision_forge::CollisionRequest asked,
                          collision_forge::CollisionAnswer& answer) const {
  const auto parsed = fromMessage(asked, config_.crash);
  if (const Status* refusal = std::get_if<Status>(&parsed)) return *refusal;
  if (!methods_.has(method)) {
    return {StatusCode::kInvalidInput,
            "method = \"" + method + "\" is none of the topic attack_methods"};
  }
  Moment moment{fromMessage(scene), std::nullopt, map_.lanesOfScene()};
  checkSnapshot(moment.snapshot, config_.input_limits, "scene");
  const CollisionRequest request = withFullId(std::get<CollisionRequest>(parsed), moment.snapshot);
  if (request.attacker) asked.attacker_id = *request.attacker;
  const Status recorded = checkRecording(request, moment);
  if (recorded.code != StatusCode::kOk) return recorded;
  if (!moment.lanes) return {StatusCode::kNoScene, "no usable lane_map has come yet"};
  if (method != default_method_ || request.choice == AttackerChoice::kNew) {
    forgetPatterns();
    return generateHere(method, moment, request, answer);
  }
  Status status = search_.generate(scene, asked, moment.recorded, answer.attack);
  answer.attack.method = method;
  if (status.code == StatusCode::kOk) {
    checkTrajectory(fromMessage(answer.attack.trajectory), config_.input_limits, "answer");
  }
  if (mayBeAnsweredHere(status, request)) {
    CollisionRequest again = request;
    again.alternatives = 1;
    const Status here = generateHere(method, moment, again, answer);
    if (here.code == StatusCode::kOk) status = here;
  }
  if (status.code == StatusCode::kOk && request.alternatives > 1) {
    addAlternatives(method, moment, request, answer);
  }
  return status;
}

Status AttackFinder::generateHere(const std::string& name, const Moment& moment,
                                  const CollisionRequest& request,
                                  collision_forge::CollisionAnswer& answer) const {
  const auto method = MethodMaker(name, methods_, config_.attack, foresight_).make();
  const Realization found = generateCollision(*method, moment, request, config_.attack.prediction);
  if (found.status.code != StatusCode::kOk) return found.status;
  answer.attack = toMessage(found, name, moment.snapshot.now);
  setAlternatives(found.alternatives, name, moment.snapshot.now, answer);
  return found.status;
}

/// Further attacks beside that of the answer.
void AttackFinder::addAlternatives(const std::string& name, const Moment& moment,
                                   const CollisionRequest& request,
                                   collision_forge::CollisionAnswer& answer) const {
  const auto method = MethodMaker(name, methods_, config_.attack, foresight_).make();
  Realization first;
  first.trajectory = fromMessage(answer.attack.trajectory);
  first.report.manoeuvre = manoeuvreFromString(answer.attack.report.manoeuvre).value();
  setAlternatives(findAlternatives(first, *method, moment, request, config_.attack.prediction),
                  name, moment.snapshot.now, answer);
}

Track AttackFinder::egoFuture(const Snapshot& snapshot, const CollisionRequest& request) const {
  if (request.mode == Mode::kReplay) return recording_->ego;
  const PredictionOptions& prediction = config_.attack.prediction;
  const auto ego_futures = foresight_.egoFutures(config_.attack.ego_futures);
  return foreseenFuture(snapshot, *map_.lanes(), *ego_futures, request.tta + prediction.tail,
                        request.tta, prediction.ego_samples, request.seed, prediction)
      .ego;
}

/// In replay mode the recorded future becomes part of the moment.
Status AttackFinder::checkRecording(const CollisionRequest& request, Moment& moment) const {
  if (isRecordingAttacked()) return {StatusCode::kNoRecording, attack_in_recording_};
  const bool is_needed = request.mode == Mode::kReplay;
  if (is_needed && !recording_) {
    return {StatusCode::kNoRecording,
            "mode = replay needs the parameter recording, the bag on replay"};
  }
  const double now = moment.snapshot.now;
  const auto frame = recordedFrame(now);
  if (is_needed && !frame) {
    return {StatusCode::kNoRecording, "recording \"" + recording_->name +
                                          "\" has no frame at now = " + numberText(now) +
                                          " s: is another bag playing?"};
  }
  if (!frame) return {};
  const Status status = checkRequest(request, moment.snapshot, config_.attack.prediction);
  if (status.code != StatusCode::kOk) return status;
  const double left = recording_->ego.states.back().time - *frame;
  if (request.tta > left) {
    return {StatusCode::kBeyondRecording,
            formatted("tta = %.1f s, but the recording", request.tta) + " \"" + recording_->name +
                formatted("\" ends %.1f s from now", left)};
  }
  if (is_needed) moment.recorded = recordedFuture(*recording_, *frame);
  return {};
}

/// A contact may come later than asked for, and then after the end of the recording.
Status AttackFinder::checkContact(const collision_forge::CollisionReport& report) const {
  const double now = report.header.stamp.toSec();
  const auto frame = recordedFrame(now);
  if (!frame || !report.contact) return {};
  const double left = recording_->ego.states.back().time - *frame;
  const double contact = report.contact_time.toSec() - now;
  if (contact <= left) return {};
  return {StatusCode::kBeyondRecording,
          formatted("the contact would come %.1f s from now, but the recording", contact) + " \"" +
              recording_->name + formatted("\" ends %.1f s from now", left)};
}

/// Returns nullopt where the scene is not of the recording, or none is known.
std::optional<double> AttackFinder::recordedFrame(double now) const {
  constexpr double kFrameTolerance = 1e-3;  // s
  if (!recording_ || recording_->ego.states.empty()) return std::nullopt;
  const auto frame = lastFrameTime(*recording_, now);
  return frame && std::abs(*frame - now) <= kFrameTolerance ? frame : std::nullopt;
}

}  // namespace forge
