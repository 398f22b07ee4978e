#include "attack/realizer.h"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>

#include "attack/limits.h"
#include "attack/placement.h"
#include "attack/quintic_join.h"

namespace forge {
namespace {

/// A step away from a pattern.
struct Variation {
  double heading = 0.0;       ///< rad
  double slide = 0.0;         ///< share of half the side that is hit
  double speed_factor = 1.0;  ///< of the pattern's attacker speed
};

std::vector<Variation> drawVariations(std::uint64_t seed, const RealizationOptions& options) {
  std::mt19937_64 generator(seed);
  // The standard's distributions differ between libraries; the generator does not.
  const auto uniform = [&generator](double low, double high) {
    const double unit = static_cast<double>(generator() >> 11) * 0x1p-53;
    return low + unit * (high - low);
  };
  std::vector<Variation> variations(1);
  for (int i = 1; i < options.samples; ++i) {
    Variation variation;
    variation.heading = uniform(-options.heading_spread, options.heading_spread);
    variation.slide = uniform(-options.slide_spread, options.slide_spread);
    variation.speed_factor = uniform(options.min_speed_factor, options.max_speed_factor);
    variations.push_back(variation);
  }
  return variations;
}

/// The side of the ego that the pattern's attacker stands at.
Side sideOf(const CollisionPattern& pattern) {
  if (pattern.type == CollisionType::kRearEnd) return Side::kRear;
  if (pattern.type == CollisionType::kOppositeDirection) return Side::kFront;
  return pattern.attacker_offset.y > 0.0 ? Side::kLeft : Side::kRight;
}

CollisionPattern varied(CollisionPattern pattern, const Variation& variation,
                        const BoxSize& attacker, double depth) {
  const double heading = wrapAngle(pattern.attacker_offset.yaw + variation.heading);
  pattern.attacker_offset =
      attackerOffset(pattern.ego.size, attacker, sideOf(pattern), heading, variation.slide, depth);
  pattern.attacker_speed = pattern.attacker_speed * variation.speed_factor;
  return pattern;
}

/// A pattern's variation with what it takes to drive it.
struct Attempt {
  CollisionPattern pattern;
  AttackerTrajectory trajectory;
  double effort = 0.0;
};

const Track& attackerOf(const CollisionPattern& pattern, const Snapshot& snapshot) {
  const auto attacker =
      std::find_if(snapshot.agents.begin(), snapshot.agents.end(),
                   [&](const Track& agent) { return agent.id == pattern.attacker_id; });
  if (attacker == snapshot.agents.end()) {
    throw std::invalid_argument("the pattern's attacker_id \"" + pattern.attacker_id +
                                "\" is nobody in the scene");
  }
  return *attacker;
}

/// Counts why variations were not taken, for the message of a refusal.
class Rejections {
 public:
  void add(const std::string& reason) { ++counts_[reason]; }

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

/// All variations of all patterns that keep the limits, least effort first.
std::vector<Attempt> drivableAttempts(const std::vector<CollisionPattern>& patterns,
                                      const VerificationInput& input, const AttackOptions& options,
                                      Rejections& rejections) {
  const std::vector<Variation> variations = drawVariations(input.request.seed, options.realization);
  std::vector<Attempt> attempts;
  for (const CollisionPattern& pattern : patterns) {
    const Track& attacker = attackerOf(pattern, input.snapshot);
    const Motion motion = estimateMotion(attacker, options.prediction.motion_frames);
    for (const Variation& variation : variations) {
      const CollisionPattern target =
          varied(pattern, variation, attacker.size, options.realization.depth);
      AttackerTrajectory trajectory =
          joinByQuintic(attacker, motion, input.snapshot.now, target, options.realization);
      const auto broken =
          findBrokenLimit(trajectory, motion.pose.yaw, target.time, options.vehicle_limits);
      if (broken) {
        rejections.add("broke " + broken->name);
        continue;
      }
      const double cost = effort(trajectory, target.time, options.vehicle_limits);
      attempts.push_back({target, std::move(trajectory), cost});
    }
  }
  std::stable_sort(attempts.begin(), attempts.end(),
                   [](const Attempt& a, const Attempt& b) { return a.effort < b.effort; });
  return attempts;
}

std::string shortcoming(const CollisionReport& report) {
  if (!report.contact) return "missed the ego";
  if (!report.first_other_id.empty()) return "touched someone else first";
  if (!report.on_time) return "made contact at the wrong time";
  if (!report.type_kept) return "made contact at the wrong relative heading";
  return "broke " + report.broken_bound;
}

}  // namespace

Realization realize(const std::vector<CollisionPattern>& patterns, const VerificationInput& input,
                    const AttackOptions& options) {
  Rejections rejections;
  Realization best;
  double best_cost = 0.0;
  int verified = 0;
  for (const Attempt& attempt : drivableAttempts(patterns, input, options, rejections)) {
    CollisionReport report = verifyMotion(attempt.trajectory, input, options);
    if (!report.verified()) {
      rejections.add(shortcoming(report));
      continue;
    }
    report.off_road_share =
        offRoadShare(attempt.trajectory, report, input.lanes, options.verification);
    const double cost =
        attempt.effort + options.realization.off_road_weight * report.off_road_share;
    if (verified == 0 || cost < best_cost) {
      best.pattern = attempt.pattern;
      best.trajectory = attempt.trajectory;
      best.report = report;
      best_cost = cost;
    }
    if (++verified >= options.realization.compared) break;
  }
  if (verified == 0) {
    best.status = {StatusCode::kNoAttackWithinBounds,
                   "no variation of " + std::to_string(patterns.size()) +
                       " patterns passed: " + rejections.summary()};
    return best;
  }
  best.report.confidence = confidence(best.trajectory, input, options);
  return best;
}

}  // namespace forge
