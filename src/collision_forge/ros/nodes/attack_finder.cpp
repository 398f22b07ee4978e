#include "collision_forge/ros/nodes/attack_finder.h"

#include <cmath>

#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/attack/search/search_method.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/bags/bag_reader.h"
#include "collision_forge/ros/bags/recorded_attack.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {

AttackFinder::AttackFinder(ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           const Config& config)
    : config_(config),
      methods_(loadMethods(config)),
      models_(loadPredictionModels(config)),
      default_method_(forge::defaultMethod(models_.network != nullptr)),
      map_(node, config.input_limits),
      predict_(node.resolveName(names::kPredictPattern), config.live.answer_within),
      realize_(node.resolveName(names::kRealizeTrajectory), config.live.answer_within) {
  loadRecording(private_node.param<std::string>("recording", ""));
}

void AttackFinder::loadRecording(const std::string& path) {
  if (path.empty()) return;
  std::vector<std::string> warnings;
  try {
    const auto attack = readRecordedAttack(path);
    if (attack) attack_in_recording_ = refusalOf(*attack, path);
    recording_ = IndexedScene{readBag(path, config_, &warnings), nullptr};
    recording_->lanes = std::make_shared<const LaneIndex>(recording_->scene.map);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("no replay mode: " << printable(error.what()));
  }
  for (const std::string& warning : warnings) ROS_WARN_STREAM(printable(path + ": " + warning));
}

std::variant<Moment, Status> AttackFinder::momentOf(
    const collision_forge::SceneSnapshot& scene) const {
  Snapshot snapshot = fromMessage(scene);
  checkSnapshot(snapshot, config_.input_limits, "scene");
  if (const auto frame = recordedFrame(snapshot)) {
    return momentAt(*recording_, *frame, config_.attack.prediction.history_frames);
  }
  Moment moment{std::move(snapshot), std::nullopt, map_.lanesOfScene()};
  if (!moment.lanes) return Status{StatusCode::kNoScene, "no usable lane_map received yet"};
  return moment;
}

Attack AttackFinder::answer(const Moment& moment, const CollisionRequest& request,
                            const std::string& method,
                            const PatternPredictorService::OnPrediction& on_prediction) const {
  if (!method.empty() && !methods_.has(method)) {
    return rejection({StatusCode::kInvalidInput,
                      "method = \"" + method + "\" is not listed on the topic attack_methods"});
  }
  const Status recorded = checkRecording(moment, request);
  if (recorded.code != StatusCode::kOk) return rejection(recorded);
  Attack answer = find(moment, request, method, on_prediction);
  if (answer.status.code != StatusCode::kOk) return answer;
  const Status contact = checkContact(moment, answer.report);
  return contact.code == StatusCode::kOk ? answer : rejection(contact);
}

Attack AttackFinder::find(const Moment& moment, const CollisionRequest& request,
                          const std::string& method,
                          const PatternPredictorService::OnPrediction& on_prediction) const {
  const PredictionOptions& prediction = config_.attack.prediction;
  if (!method.empty() && method != default_method_) {
    const MethodMaker maker(method, methods_, config_.attack, models_);
    return generateCollision(*maker.make(), moment, request, prediction);
  }
  const SearchMethod search(
      config_.attack,
      std::make_shared<PatternPredictorService>(predict_, config_.input_limits, on_prediction),
      std::make_shared<TrajectoryRealizerService>(realize_, config_.input_limits, config_.attack));
  return generateCollision(search, moment, request, prediction);
}

Status AttackFinder::checkRecording(const Moment& moment, const CollisionRequest& request) const {
  if (isRecordingAttacked()) return {StatusCode::kNoRecording, attack_in_recording_};
  const bool is_needed = request.mode == Mode::kReplay;
  if (is_needed && !recording_) {
    return {StatusCode::kNoRecording,
            "mode = replay needs the node parameter recording: the path of the replayed bag"};
  }
  if (is_needed && !moment.recorded) {
    return {StatusCode::kNoRecording,
            "recording \"" + recording_->scene.name +
                "\" has no frame with this ego pose at t0 = " + numberText(moment.snapshot.now) +
                " s: is another bag playing?"};
  }
  if (!moment.recorded) return {};
  const Status status = checkRequest(withFullId(request, moment.snapshot), moment.snapshot,
                                     config_.attack.prediction);
  if (status.code != StatusCode::kOk) return status;
  const double left = secondsLeft(moment);
  if (request.tta <= left) return {};
  return {StatusCode::kBeyondRecording, formatted("tta = %.1f s, but the recording", request.tta) +
                                            " \"" + recording_->scene.name +
                                            formatted("\" ends %.1f s after t0", left)};
}

/// Rejects an attack whose contact, later than requested, is after the end of the recording.
Status AttackFinder::checkContact(const Moment& moment, const CollisionReport& report) const {
  if (!moment.recorded || !report.contact) return {};
  const double left = secondsLeft(moment);
  const double contact = report.contact_time - moment.snapshot.now;
  if (contact <= left) return {};
  return {StatusCode::kBeyondRecording,
          formatted("the contact would be %.1f s after t0, but the recording", contact) + " \"" +
              recording_->scene.name + formatted("\" ends %.1f s after t0", left)};
}

/// Returns the time (s) of the recorded frame that `snapshot` shows, matched by time and ego
/// position; nullopt if there is no recording or no such frame.
std::optional<double> AttackFinder::recordedFrame(const Snapshot& snapshot) const {
  constexpr double kFrameTolerance = 1e-3;  // s
  constexpr double kPlaceTolerance = 0.1;   // m; /tf comes at other instants than the frames
  if (!recording_ || recording_->scene.ego.states.empty()) return std::nullopt;
  if (snapshot.ego.states.empty()) return std::nullopt;
  const auto frame = lastFrameTime(recording_->scene, snapshot.now);
  if (!frame || std::abs(*frame - snapshot.now) > kFrameTolerance) return std::nullopt;
  const auto recorded = stateAt(recording_->scene.ego, *frame);
  if (!recorded) return std::nullopt;
  const Vector2 apart = recorded->pose.position() - snapshot.ego.states.back().pose.position();
  return apart.norm() <= kPlaceTolerance ? frame : std::nullopt;
}

/// Returns the seconds from t0 to the end of the recording.
double AttackFinder::secondsLeft(const Moment& moment) const {
  return recording_->scene.ego.states.back().time - moment.snapshot.now;
}

}  // namespace forge
