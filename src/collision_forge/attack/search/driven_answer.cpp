#include "collision_forge/attack/search/driven_answer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/request_check.h"

namespace forge {

const Track& trackOf(const Snapshot& snapshot, const std::string& id) {
  const auto& agents = snapshot.agents;
  const auto found = std::find_if(agents.begin(), agents.end(),
                                  [&](const Track& track) { return track.id == id; });
  if (found == agents.end())
    throw std::invalid_argument("agent \"" + id + "\" is not in the snapshot");
  return *found;
}

void goStraightOn(AttackerTrajectory& trajectory, double duration, double step) {
  const TrajectoryPoint last = trajectory.points.back();
  const int steps = static_cast<int>(std::lround(duration / step));
  for (int i = 1; i <= steps; ++i) {
    const double elapsed = i * step;
    trajectory.points.push_back({last.time + elapsed,
                                 compose(last.pose, {last.speed * elapsed, 0.0, 0.0}), last.speed,
                                 0.0, 0.0});
  }
}

Attack drivenAttack(AttackerTrajectory trajectory, const Moment& moment, CollisionRequest request,
                    const AttackOptions& options, const CollisionPattern* aim) {
  request.crash.limits = LimitSet::kStrict;
  const PredictionOptions& prediction = options.prediction;
  const Future future = moment.recorded ? *moment.recorded
                                        : predictFuture(moment.snapshot, *moment.lanes,
                                                        request.tta + prediction.tail);
  Attack answer;
  answer.report =
      verify(trajectory, {moment.snapshot, future, request, *moment.lanes}, options.verification);
  const CollisionReport& report = answer.report;
  const Pose2 met = relativeTo(report.ego_at_contact, report.attacker_at_contact);
  answer.pattern = aim ? *aim
                       : CollisionPattern{request.type,
                                          trajectory.attacker_id,
                                          report.contact_time,
                                          {report.ego_at_contact, moment.snapshot.ego.size},
                                          met,
                                          trajectory.points.back().speed};
  answer.miss = missBetween(answer.pattern.attacker_offset, met);
  answer.trajectory = std::move(trajectory);
  return answer;
}

Attack bestOfCandidates(const Moment& moment, const CollisionRequest& request,
                        const PredictionOptions& options,
                        const std::function<Attack(const std::string&)>& answer_of) {
  if (request.attacker) return answer_of(*request.attacker);
  std::optional<Attack> best;
  const auto rank = [](const Attack& answer) {
    return answer.report.verified() ? 2 : answer.report.contact ? 1 : 0;
  };
  for (const Track& agent : moment.snapshot.agents) {
    if (!isCandidate(agent, moment.snapshot, options, request.attacker_class)) continue;
    if (request.attacker_class && agent.agent_class != *request.attacker_class) continue;
    Attack answer = answer_of(agent.id);
    if (!best || rank(answer) > rank(*best)) best = std::move(answer);
  }
  if (best) return std::move(*best);
  return rejection(
      {StatusCode::kNoCandidate,
       "no vehicle within candidate_radius was observed at t0 and in the frame before"});
}

}  // namespace forge
