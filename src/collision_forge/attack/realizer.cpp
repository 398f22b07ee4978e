#include "collision_forge/attack/realizer.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "collision_forge/attack/attack_search.h"

namespace forge {
namespace {

void checkPatterns(const std::vector<CollisionPattern>& patterns, const Snapshot& snapshot) {
  for (const CollisionPattern& pattern : patterns) {
    const bool known =
        std::any_of(snapshot.agents.begin(), snapshot.agents.end(),
                    [&](const Track& agent) { return agent.id == pattern.attacker_id; });
    if (!known) {
      throw std::invalid_argument("the pattern's attacker_id \"" + pattern.attacker_id +
                                  "\" is nobody in the scene");
    }
    if (!(pattern.time > snapshot.now)) {
      throw std::invalid_argument("the pattern's time is not after now");
    }
  }
}

/// Counts why attacks were not taken, for the message of a refusal.
class Rejections {
 public:
  void add(const CollisionReport& report) { ++counts_[shortcomingOf(report)]; }

  std::string summary() const {
    std::string text;
    for (const auto& [reason, count] : counts_) {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + reason;
    }
    return text;
  }

 private:
  std::map<std::string, int> counts_;
};

/// Every second sample, from `first` on; the known ego without samples.
std::vector<const Track*> everySecond(const Future& future, std::size_t first) {
  std::vector<const Track*> egos;
  for (std::size_t i = first; i < future.ego_samples.size(); i += 2) {
    egos.push_back(&future.ego_samples[i]);
  }
  if (egos.empty()) egos.push_back(&future.ego);
  return egos;
}

/// The pattern that an attack makes at its contact with the ego.
CollisionPattern patternOf(const FoundAttack& attack, const CollisionReport& report,
                           const VerificationInput& input) {
  CollisionPattern pattern;
  pattern.type = input.request.type;
  pattern.attacker_id = attack.attacker->id;
  pattern.time = report.contact_time;
  pattern.ego = {report.ego_at_contact, input.snapshot.ego.size};
  pattern.attacker_offset = relativeTo(report.ego_at_contact, report.attacker_at_contact);
  for (const TrajectoryPoint& point : attack.points) {
    pattern.attacker_speed = point.speed;
    if (point.time >= report.contact_time) break;
  }
  return pattern;
}

/// Verifies the attack in the futures that it should hit, until one bears it out.
bool verifyInFutures(const FoundAttack& attack, const std::vector<const Track*>& egos,
                     const std::vector<std::size_t>& hits, const VerificationInput& input,
                     const AttackOptions& options, Rejections& rejections, Realization& found) {
  constexpr std::size_t kTries = 4;
  const Track& agent = *attack.attacker;
  found.trajectory = {agent.id, agent.agent_class, agent.size, attack.points};
  Future future = input.future;
  for (std::size_t i = 0; i < std::min(kTries, hits.size()); ++i) {
    // From the middle of the hits, which are in the order of the samples.
    const std::size_t hit = hits[(hits.size() / 2 + i) % hits.size()];
    future.ego = *egos[hit];
    found.report = verify(found.trajectory, {input.snapshot, future, input.request, input.lanes},
                          options.verification);
    if (!found.report.verified()) {
      rejections.add(found.report);
      continue;
    }
    found.pattern = patternOf(attack, found.report, input);
    return true;
  }
  return false;
}

}  // namespace

std::string shortcomingOf(const CollisionReport& report) {
  if (!report.contact) return "missed the ego";
  if (!report.first_other_id.empty()) return "touched someone else first";
  if (!report.on_time) return "made contact at the wrong time";
  if (!report.type_kept) return "made contact in another way";
  return "broke " + report.broken_bound;
}

double confidenceOf(double share, const std::vector<double>& curve) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(curve.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), curve.size() - 2);
  return curve[i] + (place - static_cast<double>(i)) * (curve[i + 1] - curve[i]);
}

Realization realize(const std::vector<CollisionPattern>& patterns, const VerificationInput& input,
                    const AttackOptions& options) {
  checkPatterns(patterns, input.snapshot);
  const std::vector<const Track*> searched = everySecond(input.future, 0);
  const std::vector<const Track*> held_out = everySecond(input.future, 1);
  const std::vector<FoundAttack> attacks = searchAttacks(
      {input.snapshot, input.future, searched, patterns, input.request, input.lanes}, options);
  const auto scorerOf = [&](const std::vector<const Track*>& egos) {
    return FutureScorer(egos, input.future.agents, input.request, input.snapshot.now,
                        input.lanes.map().driving_side, options);
  };
  const FutureScorer searched_scorer = scorerOf(searched);
  Rejections rejections;
  Realization found;
  for (const FoundAttack& attack : attacks) {
    const auto hits = searched_scorer.hits(*attack.attacker, attack.points);
    if (!verifyInFutures(attack, searched, hits, input, options, rejections, found)) continue;
    found.report.confidence =
        input.future.ego_samples.empty()
            ? 1.0
            : confidenceOf(scorerOf(held_out).score(*attack.attacker, attack.points).share,
                           options.search.confidence_curve);
    if (found.report.confidence < input.request.crash.min_confidence) {
      Realization declined;
      declined.status = {
          StatusCode::kLowConfidence,
          "the best attack promises " + std::to_string(found.report.confidence) +
              ", less than min_confidence = " + std::to_string(input.request.crash.min_confidence)};
      return declined;
    }
    return found;
  }
  found.status = {StatusCode::kNoAttackWithinBounds,
                  "no attack by " + std::to_string(patterns.size()) +
                      " patterns holds within the limits; best ones: " +
                      (attacks.empty() ? "none" : rejections.summary())};
  return found;
}

}  // namespace forge
