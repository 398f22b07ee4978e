#include "collision_forge/study/generators/published_predictor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/forecast/motion_estimate.h"
#include "collision_forge/attack/search/driven_answer.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {

using torch::Tensor;

Tensor relativeYaws(const PublishedPrediction& predicted, const TrafficBatch& batch,
                    int history_frames) {
  const Tensor places = batch.poses.select(2, history_frames - 1).slice(2, 0, 2);
  const Tensor from_ego = places - predicted.ego_place.unsqueeze(1);
  const Tensor yaw = predicted.ego_yaw.unsqueeze(1);
  const Tensor left =
      torch::cos(yaw) * from_ego.select(2, 1) - torch::sin(yaw) * from_ego.select(2, 0);
  const Tensor side = torch::where(left > 0.0, -1.0, 1.0);
  return side * predicted.attacker_yaw.unsqueeze(1);
}

namespace {

/// See makePublishedPredictor().
class PublishedPatternPredictor : public PatternPredictor {
 public:
  PublishedPatternPredictor(RunPublishedNetwork run_network, const TrafficOptions& traffic,
                            const PredictionOptions& options)
      : run_network_(std::move(run_network)), traffic_(traffic), options_(options) {}

  PatternPrediction predict(const Snapshot& snapshot, const LaneIndex& lanes,
                            const CollisionRequest& request,
                            const Future* recorded) const override {
    PatternPrediction prediction;
    prediction.future = recorded
                            ? *recorded
                            : predictFuture(snapshot, lanes, request.tta + options_.tail, options_);
    const std::vector<std::string> allowed = allowedBy(request, snapshot);
    if (allowed.empty()) {
      prediction.status = {StatusCode::kNoCandidate, "no vehicle within candidate_radius = " +
                                                         numberText(options_.candidate_radius) +
                                                         " m was observed at t0 and in the frame "
                                                         "before"};
      return prediction;
    }
    const TrafficClip clip = trafficOf(snapshot, allowed.front(), request, traffic_, &lanes);
    const TrafficBatch batch = batchOf({{&clip, traffic_.history_frames - 1}}, traffic_, 0);
    const torch::NoGradGuard no_gradients;
    const PublishedPrediction predicted = run_network_(batch);
    if (!predicted.placed.item<bool>()) {
      prediction.status = {StatusCode::kRoadDoesNotAllow,
                           "no lane within " + numberText(traffic_.lanes.reach) +
                               " m of the ego at t0, on which the network could place the crash"};
      return prediction;
    }
    fillIn(predicted, batch, clip, allowed, snapshot, request, prediction);
    return prediction;
  }

 private:
  /// Returns the ids of the vehicles that the request allows, nearest to the ego first.
  std::vector<std::string> allowedBy(const CollisionRequest& request,
                                     const Snapshot& snapshot) const {
    if (request.attacker) return {*request.attacker};
    const Vector2 ego = snapshot.ego.states.back().pose.position();
    std::vector<std::pair<double, std::string>> found;
    for (const Track& agent : snapshot.agents) {
      if (request.attacker_class && agent.agent_class != *request.attacker_class) continue;
      if (!isCandidate(agent, snapshot, options_)) continue;
      found.emplace_back((agent.states.back().pose.position() - ego).norm(), agent.id);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> ids;
    for (auto& entry : found) ids.push_back(std::move(entry.second));
    return ids;
  }

  /// Appends a pattern for each allowed vehicle that is in the network's input.
  void fillIn(const PublishedPrediction& predicted, const TrafficBatch& batch,
              const TrafficClip& clip, const std::vector<std::string>& allowed,
              const Snapshot& snapshot, const CollisionRequest& request,
              PatternPrediction& prediction) const {
    const Tensor yaws = relativeYaws(predicted, batch, traffic_.history_frames)[0];
    const Tensor offset = predicted.offset[0], place = predicted.ego_place[0];
    const auto number = [](const Tensor& tensor) {
      const double found = tensor.item<double>();
      if (!std::isfinite(found)) {
        throw std::runtime_error("the published network returns values that are not finite");
      }
      return found;
    };
    const Pose2 now = estimateMotion(snapshot.ego, options_.motion_frames).pose;
    const Pose2 ego =
        compose(now, {number(place[0]), number(place[1]), number(predicted.ego_yaw[0])});
    const Tensor order = predicted.selection[0].argsort(0, true);
    for (long i = 0; i < order.size(0); ++i) {
      const long agent = order[i].item<long>();
      const std::string& id = clip.ids[static_cast<std::size_t>(agent)];
      if (std::find(allowed.begin(), allowed.end(), id) == allowed.end()) continue;
      CollisionPattern pattern;
      pattern.type = request.type;
      pattern.attacker_id = id;
      pattern.time = snapshot.now + request.tta;
      pattern.ego = boxAt(snapshot.ego, ego);
      pattern.attacker_offset = {number(offset[0]), number(offset[1]), number(yaws[agent])};
      pattern.attacker_speed = estimateMotion(trackOf(snapshot, id), options_.motion_frames).speed;
      pattern.tolerance = options_.network_pattern_tolerance;
      prediction.patterns.push_back(std::move(pattern));
    }
  }

  RunPublishedNetwork run_network_;
  TrafficOptions traffic_;
  PredictionOptions options_;
};

}  // namespace

std::shared_ptr<const PatternPredictor> makePublishedPredictor(RunPublishedNetwork run_network,
                                                               const TrafficOptions& traffic,
                                                               const PredictionOptions& options) {
  return std::make_shared<PublishedPatternPredictor>(std::move(run_network), traffic, options);
}

}  // namespace forge
