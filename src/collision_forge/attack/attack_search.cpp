#include "collision_forge/attack/attack_search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "collision_forge/attack/contender.h"
#include "collision_forge/attack/ground_use.h"
#include "collision_forge/attack/placement.h"
#include "collision_forge/attack/steering_search.h"
#include "collision_forge/forecast/random.h"
#include "collision_forge/verify/limits.h"

namespace forge {
namespace {

constexpr double kShrink = 0.6;          // of the perturbations, a round
constexpr double kMinArrival = 0.3;      // s from now
constexpr double kMinImpactSpeed = 0.2;  // m/s
constexpr double kMaxDrawnSpeed = 15.0;  // m/s at the impact
constexpr double kNear = 6.0;            // m from the ego's middle: boxes may touch
constexpr double kRounding = 0.999;      // of a limit, so that a bicycle at the limit is within it

VehicleLimits scaled(VehicleLimits limits, double margin) {
  limits.max_forward_acceleration *= margin;
  limits.max_braking *= margin;
  limits.max_total_acceleration *= margin;
  limits.max_curvature *= margin;
  limits.max_speed *= margin;
  limits.heading_slack *= margin;
  limits.heading_per_metre *= margin;
  return limits;
}

struct Candidate {
  const Contender* contender = nullptr;
  const TrajectoryFamily* family = nullptr;  // null: the bicycle, by its knots
  SteeringKnots knots;
  // What is varied.
  std::size_t ego = 0;   // future that is aimed at
  double contact = 0.0;  // s from now
  double lead = 0.0;     // s driven straight on before the contact
  Pose2 offset;          // of the attacker from the ego at the contact
  Arrival arrival;       // its time and pose follow from these
  FutureScore score;
  double off_road = 0.0;
  double steering = 0.0;  // fastest, 1/(m s)
  double objective = 0.0;
};

class Search {
 public:
  Search(const SearchInput& input, const AttackOptions& options)
      : input_(input),
        options_(options),
        search_(options.search),
        slack_(input.request.crash.time_tolerance - options.search.time_margin),
        limits_(scaled(options.verification.limits, options.search.limit_margin)),
        bicycle_(scaled(limits_, kRounding), options.bicycle),
        scorer_(input.egos, input.future.agents, input.request, input.snapshot.now,
                input.lanes.map().driving_side, options),
        ground_(input.lanes,
                std::max(1, static_cast<int>(std::lround(options.verification.off_road_interval /
                                                         options.search.step)))),
        contenders_(contendersOf(input, options, limits_, scorer_.steps())),
        random_(input.request.seed) {
    chooseEgos();
  }

  std::vector<FoundAttack> run() {
    for (const auto& contender : contenders_) drawFor(*contender);
    for (int round = 0; round < search_.rounds && !isGood(); ++round) {
      perturb(quintics_, search_.perturbations, std::pow(kShrink, round));
    }
    if (!isGood()) {
      steerToArrivals();
      if (bestShare() == 0.0) steerAnyhow();
      for (int round = 0; round < search_.bicycle_rounds && !isGood(); ++round) {
        perturb(bicycles_, search_.bicycle_perturbations, std::pow(kShrink, round));
      }
    }
    std::vector<Candidate> all = quintics_;
    all.insert(all.end(), bicycles_.begin(), bicycles_.end());
    std::stable_sort(all.begin(), all.end(), better);
    std::vector<FoundAttack> found;
    for (const Candidate& candidate : all) {
      if (candidate.score.share > 0.0) found.push_back(finished(candidate));
    }
    return found;
  }

 private:
  /// Futures to aim at, spread over all of them along the way.
  void chooseEgos() {
    const double impact = input_.request.tta;
    const Pose2 now = input_.snapshot.ego.states.back().pose;
    std::vector<std::size_t> order(input_.egos.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> along;
    for (std::size_t i : order) along.push_back(relativeTo(now, egoAt(i, impact)).x);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
    const int count = std::min(search_.ego_poses, static_cast<int>(order.size()));
    for (int i = 0; i < count; ++i) {
      const double rank = (i + 0.5) / count * static_cast<double>(order.size());
      egos_.push_back(order[static_cast<std::size_t>(rank)]);
    }
  }

  Pose2 egoAt(std::size_t ego, double seconds) const {
    const Track& track = *input_.egos[ego];
    return stateAt(track, input_.snapshot.now + seconds).value_or(track.states.back()).pose;
  }

  /// An offset of the attacker from the ego's box, drawn from a placement's.
  Pose2 drawOffset(const Contender& contender, const Placement& placement, bool nominal) {
    const TypeDefinition& type = input_.request.bands();
    double heading = type.nominal_heading;
    double slide = 0.0;
    if (!nominal) {
      heading = random_.uniform(type.min_heading, type.max_heading);
      slide = random_.uniform(-0.9, 0.9);
    }
    double sign = placement.sign;
    if (sign == 0.0) sign = nominal || random_.uniform(-1.0, 1.0) > 0.0 ? 1.0 : -1.0;
    return attackerOffset(input_.snapshot.ego.size, contender.track->size, placement.side,
                          wrapAngle(sign * heading), slide, search_.depth);
  }

  /// Speed at the contact for which a steady change of speed covers the distance.
  double steadySpeed(const Contender& contender, const Pose2& target, double contact) const {
    const double distance = (target.position() - contender.start.motion.pose.position()).norm();
    return std::clamp(2.0 * distance / contact - contender.start.motion.speed, 0.5,
                      limits_.max_speed);
  }

  /// The time and pose to arrive at for the candidate's contact.
  void aim(Candidate& candidate) const {
    const double earliest = std::max(kMinArrival, input_.request.tta - slack_);
    candidate.contact =
        std::clamp(candidate.contact, earliest, std::max(earliest, input_.request.tta + slack_));
    candidate.lead = std::clamp(candidate.lead, 0.0, candidate.contact - kMinArrival);
    Arrival& arrival = candidate.arrival;
    arrival.speed = std::clamp(arrival.speed, kMinImpactSpeed, limits_.max_speed);
    arrival.time = candidate.contact - candidate.lead;
    const Pose2 contact = compose(egoAt(candidate.ego, candidate.contact), candidate.offset);
    arrival.pose = compose(contact, {-arrival.speed * candidate.lead, 0.0, 0.0});
  }

  /// An arrival somewhere at the placement; the nominal one at its middle. `steady`: at a speed
  /// that a steady change of speed leads to.
  Candidate drawn(const Contender& contender, const Placement& placement, bool nominal,
                  bool steady) {
    Candidate candidate;
    candidate.contender = &contender;
    candidate.ego = nominal ? egos_[egos_.size() / 2] : egos_[random_.index(egos_.size())];
    candidate.offset = drawOffset(contender, placement, nominal);
    candidate.contact = input_.request.tta;
    if (!nominal) {
      candidate.contact += random_.uniform(-slack_, slack_);
      candidate.lead = std::max(0.0, random_.uniform(-search_.max_lead, search_.max_lead));
    }
    Arrival& arrival = candidate.arrival;
    const Pose2 target = compose(egoAt(candidate.ego, candidate.contact), candidate.offset);
    arrival.speed = steadySpeed(contender, target, candidate.contact);
    arrival.start_acceleration = std::clamp(contender.start.motion.acceleration, -3.0, 3.0);
    if (!nominal) {
      // Around the steady speed or, as no straight way may lead there, any.
      arrival.speed = steady || random_.uniform(-1.0, 1.0) > 0.0
                          ? arrival.speed * random_.uniform(0.5, 1.5)
                          : random_.uniform(0.5, kMaxDrawnSpeed);
      arrival.start_acceleration = random_.bell(1.5);
      arrival.end_acceleration = random_.bell(1.5);
    }
    aim(candidate);
    return candidate;
  }

  void drawFor(const Contender& contender) {
    if (!canReach(contender)) return;
    const auto placements = placementsOf(input_.request.type, input_.lanes.map().driving_side);
    for (const Placement& placement : placements) {
      for (const auto& family : contender.quintics) {
        for (int i = 0; i < search_.draws; ++i) {
          Candidate candidate = drawn(contender, placement, i == 0, true);
          candidate.family = family.get();
          consider(candidate);
        }
      }
    }
  }

  /// False when no speed within the limits brings the attacker near any of the ego's poses in time.
  bool canReach(const Contender& contender) const {
    const Motion& motion = contender.start.motion;
    const auto near_at = [&](double seconds) {
      const double speed = std::min(
          limits_.max_speed, motion.speed + 0.5 * limits_.max_forward_acceleration * seconds);
      return std::any_of(egos_.begin(), egos_.end(), [&](std::size_t ego) {
        const Vector2 position = egoAt(ego, seconds).position();
        return (position - motion.pose.position()).norm() < speed * seconds + kNear;
      });
    };
    return near_at(input_.request.tta) || near_at(input_.request.tta + slack_);
  }

  bool drive(const Candidate& candidate, const DriveStart& start,
             std::vector<TrajectoryPoint>& points) const {
    if (candidate.family) return candidate.family->drive(start, candidate.arrival, points);
    bicycle_.roll(start, candidate.knots, candidate.arrival.time, points);
    return true;
  }

  /// Drives the candidate, scores it, and keeps it if it is among the best of its kind.
  void consider(Candidate& candidate) {
    const DriveStart& start = candidate.contender->start;
    if (!drive(candidate, start, points_)) return;
    const double until = start.now + input_.request.tta + input_.request.crash.time_tolerance;
    if (!keepsLimits(points_, start.motion.pose.yaw, until, limits_)) return;
    candidate.score = scorer_.score(*candidate.contender->track, points_);
    candidate.objective =
        candidate.score.share + search_.closeness_weight * candidate.score.closeness;
    std::vector<Candidate>& kept = candidate.family ? quintics_ : bicycles_;
    const bool full = static_cast<int>(kept.size()) >= search_.kept;
    if (full && candidate.objective < kept.back().objective) return;
    const BoxSize& size = candidate.contender->track->size;
    if (ground_.crossesKerb(points_, size)) return;
    const double arrival = start.now + input_.request.tta;
    candidate.off_road = ground_.offRoadShare(points_, arrival, size);
    candidate.steering = fastestSteering(points_, arrival, limits_);
    candidate.objective -= search_.off_road_weight * candidate.off_road +
                           search_.effort_weight * effort(points_, arrival, limits_) +
                           search_.steering_weight * beyond(candidate.steering);
    kept.insert(std::upper_bound(kept.begin(), kept.end(), candidate, better), candidate);
    if (static_cast<int>(kept.size()) > search_.kept) kept.pop_back();
  }

  /// What steering counts: nothing while quick_steering is not exceeded, 1 when it is by far.
  double beyond(double steering) const {
    return 1.0 - search_.quick_steering / std::max(search_.quick_steering, steering);
  }

  static bool better(const Candidate& a, const Candidate& b) { return a.objective > b.objective; }

  double bestShare() const {
    double share = 0.0;
    for (const auto* kept : {&quintics_, &bicycles_}) {
      if (!kept->empty()) share = std::max(share, kept->front().score.share);
    }
    return share;
  }

  bool isGood() const {
    const auto good = [this](const std::vector<Candidate>& kept) {
      return !kept.empty() && kept.front().score.share >= search_.good_share &&
             kept.front().off_road <= search_.good_off_road &&
             kept.front().steering <= search_.good_steering;
    };
    return good(quintics_) || good(bicycles_);
  }

  /// Moves away from the kept candidates, better ones more often.
  void perturb(const std::vector<Candidate>& kept, int count, double scale) {
    const std::vector<Candidate> parents = kept;
    if (parents.empty()) return;
    for (int i = 0; i < count && !isGood(); ++i) {
      const std::size_t rank =
          std::min(random_.index(parents.size()), random_.index(parents.size()));
      Candidate candidate = parents[rank];
      if (candidate.family) {
        moveArrival(candidate, scale);
      } else {
        moveKnots(candidate.knots, scale);
      }
      consider(candidate);
    }
  }

  void moveArrival(Candidate& candidate, double scale) {
    Pose2& offset = candidate.offset;
    offset.x += random_.bell(1.0 * scale);
    offset.y += random_.bell(0.6 * scale);
    offset.yaw = wrapAngle(offset.yaw + random_.bell(0.07 * scale));
    candidate.contact += random_.bell(0.2 * scale);
    candidate.lead += random_.bell(0.2 * scale);
    Arrival& arrival = candidate.arrival;
    arrival.speed += random_.bell((0.5 + 0.15 * arrival.speed) * scale);
    arrival.start_acceleration += random_.bell(1.0 * scale);
    arrival.end_acceleration += random_.bell(1.0 * scale);
    aim(candidate);
  }

  void moveKnots(SteeringKnots& knots, double scale) {
    for (double& knot : knots.acceleration) knot += random_.bell(1.2 * scale);
    for (double& knot : knots.curvature) knot += random_.bell(0.02 * scale);
  }

  /// Steers the bicycle to arrivals of every attacker in turn.
  void steerToArrivals() {
    const auto placements = placementsOf(input_.request.type, input_.lanes.map().driving_side);
    std::vector<const Contender*> reachable;
    for (const auto& contender : contenders_) {
      if (canReach(*contender)) reachable.push_back(contender.get());
    }
    if (reachable.empty()) return;
    for (int i = 0; i < search_.bicycle_targets && !isGood(); ++i) {
      const auto turn = static_cast<std::size_t>(i);
      const Contender& contender = *reachable[turn % reachable.size()];
      const Placement& placement = placements[turn / reachable.size() % placements.size()];
      Candidate candidate =
          drawn(contender, placement, turn < reachable.size() * placements.size(), false);
      const auto knots = bicycle_.solve(contender.start, candidate.arrival);
      if (!knots) continue;
      candidate.knots = *knots;
      consider(candidate);
    }
  }

  /// Steers every attacker's bicycle to one future of the ego, wherever and however it may touch.
  void steerAnyhow() {
    const double end = input_.request.tta + slack_;
    const SteeringOptions& steering = options_.steering;
    SteeringAim aim;
    aim.ego_size = input_.snapshot.ego.size;
    aim.band = input_.request.bands();
    aim.first_in_time = input_.request.tta - slack_;
    aim.last_in_time = end;
    aim.depth = search_.depth;
    const int steps = static_cast<int>(std::ceil(end / steering.step));
    for (int i = 0; i <= steps; ++i) {
      aim.ego.push_back(egoAt(egos_[egos_.size() / 2], end * i / steps));
    }
    std::vector<std::pair<const Contender*, SteeringSearch>> searches;
    for (const auto& contender : contenders_) {
      if (!canReach(*contender)) continue;
      aim.attacker_size = contender->track->size;
      searches.emplace_back(contender.get(),
                            SteeringSearch(contender->start, aim, limits_, steering));
    }
    for (int round = 0; round < steering.rounds && !isGood(); ++round) {
      for (auto& [contender, search] : searches) {
        if (round >= steering.patience && search.shortfall() > steering.hopeless) continue;
        Candidate candidate;
        candidate.contender = contender;
        candidate.arrival.time = end;
        for (const SteeringKnots& knots : search.next(random_)) {
          candidate.knots = knots;
          consider(candidate);
        }
        if (isGood()) break;
      }
    }
  }

  FoundAttack finished(const Candidate& candidate) const {
    FoundAttack found;
    found.attacker = candidate.contender->track;
    DriveStart start = candidate.contender->start;
    const double end = input_.request.tta + search_.tail;
    start.points = std::max(scorer_.steps(), static_cast<int>(std::lround(end / search_.step)) + 1);
    drive(candidate, start, found.points);
    found.score = candidate.score;
    found.off_road = candidate.off_road;
    found.objective = candidate.objective;
    return found;
  }

  const SearchInput& input_;
  const AttackOptions& options_;
  const SearchOptions& search_;
  double slack_;  // s that a contact may be early or late
  VehicleLimits limits_;
  BicycleFamily bicycle_;
  FutureScorer scorer_;
  GroundUse ground_;
  std::vector<std::unique_ptr<Contender>> contenders_;
  Random random_;
  std::vector<std::size_t> egos_;    // that are aimed at
  std::vector<Candidate> quintics_;  // best first
  std::vector<Candidate> bicycles_;  // best first
  std::vector<TrajectoryPoint> points_;
};

}  // namespace

std::vector<FoundAttack> searchAttacks(const SearchInput& input, const AttackOptions& options) {
  return Search(input, options).run();
}

}  // namespace forge
