#include "collision_forge/attack/search/attack_search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/arrival_sampler.h"
#include "collision_forge/attack/search/contender.h"
#include "collision_forge/attack/search/ground_use.h"
#include "collision_forge/attack/search/manoeuvre_search.h"
#include "collision_forge/attack/search/request_constraints.h"
#include "collision_forge/attack/search/steering_search.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/limits.h"

namespace forge {
namespace {

constexpr double kEffortWeight = 0.02;  // cost of driving at the limits, share of the futures
// 1/(m s) of curvature. Slower steering costs nothing, twice as fast steering half of
// steering_weight. 0.8 rad/s at the wheels of a car with a wheelbase of 2.7 m: twice the limit of
// CommonRoad's vehicle models (v_delta, 0.4 rad/s).
constexpr double kQuickSteering = 0.3;
// SteeringSearch ends for an attacker that is still kHopeless m short of the target after kPatience
// rounds.
constexpr int kPatience = 2;
constexpr double kHopeless = 5.0;
// Budget of the bicycle for SearchedMotion::kAny of plausible attackers, the second try after the
// search along routes.
constexpr int kAnyMotionBicycleTargets = 20;
constexpr int kAnyMotionBicycleRounds = 2;
constexpr double kShrink = 0.6;      // factor on perturbations per round
constexpr double kRounding = 0.999;  // factor on limits, so that a bicycle at the limit passes
constexpr double kOnPattern = 0.02;  // m; a contact nearer to its pattern needs no correction

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

/// For plausible attackers the bicycle is tried less, because few of its motions are plausible.
SearchOptions searchOptionsFor(const SearchInput& input, const AttackOptions& options) {
  SearchOptions search = options.search;
  if (!input.request.crash.believable) return search;
  search.bicycle_targets = kAnyMotionBicycleTargets;
  search.bicycle_rounds = kAnyMotionBicycleRounds;
  return search;
}

struct Candidate {
  const Contender* contender = nullptr;
  const Aim* aim = nullptr;
  bool is_quintic = false;  // else the bicycle with `knots`
  AimedArrival aimed;
  SteeringKnots knots;
  FutureScore score;
  PatternMiss miss;  // with a share above 0
  double off_road = 0.0;
  double steering = 0.0;          // greatest rate of curvature, 1/(m s)
  bool meets_constraints = true;  // plausible road use, and the request's constraints
  double objective = 0.0;
};

class Search {
 public:
  Search(const SearchInput& input, const AttackOptions& options)
      : input_(input),
        options_(options),
        search_(searchOptionsFor(input, options)),
        limits_(scaled(options.verification.limits, kLimitMargin)),
        bicycle_(scaled(limits_, kRounding)),
        scorer_(input.egos, input.future.agents, input.request, input.snapshot.now,
                input.lanes.map().driving_side, options),
        ground_(input.lanes,
                std::max(1, static_cast<int>(std::lround(options.verification.off_road_interval /
                                                         options.search.step)))),
        contenders_(contendersOf(input, options, limits_, scorer_.steps())),
        constraints_(input, options),
        random_(input.request.seed),
        sampler_(input, options, limits_, random_) {}

  std::vector<FoundAttack> run() {
    for (const auto& contender : contenders_) drawFor(*contender);
    correctContacts();
    for (int round = 0; round < search_.rounds && !isGood(); ++round) {
      perturb(quintics_, search_.perturbations, std::pow(kShrink, round));
    }
    if (!isGood()) {
      steerToArrivals();
      if (!input_.request.crash.believable && bestShare() == 0.0) steerToContact();
      for (int round = 0; round < search_.bicycle_rounds && !isGood(); ++round) {
        perturb(bicycles_, search_.bicycle_perturbations, std::pow(kShrink, round));
      }
    }
    correctContacts();
    std::vector<FoundAttack> found;
    for (const Candidate& candidate : best()) {
      if (candidate.score.share > 0.0) found.push_back(finished(candidate));
    }
    return found;
  }

 private:
  /// Returns the kept candidates of both families, best first.
  std::vector<Candidate> best() const {
    std::vector<Candidate> all = quintics_;
    all.insert(all.end(), bicycles_.begin(), bicycles_.end());
    std::stable_sort(all.begin(), all.end(), better);
    return all;
  }

  Candidate candidateFor(const Contender& contender, const Aim& aim) const {
    Candidate candidate;
    candidate.contender = &contender;
    candidate.aim = &aim;
    return candidate;
  }

  void drawFor(const Contender& contender) {
    if (!sampler_.canReach(contender)) return;
    for (const Aim& aim : contender.aims) {
      Candidate candidate = candidateFor(contender, aim);
      candidate.is_quintic = true;
      for (int i = 0; i < search_.draws; ++i) {
        candidate.aimed = drawn(contender, aim, i, true);
        consider(candidate);
      }
    }
  }

  /// Draws the pattern's own arrival at two speeds, then alternates between arrivals near it and
  /// anywhere.
  AimedArrival drawn(const Contender& contender, const Aim& aim, int draw, bool steady) {
    if (draw >= 2 && draw % 2 == 1) return sampler_.wide(contender, aim, steady);
    AimedArrival aimed = sampler_.own(contender, aim, draw != 1);
    if (draw >= 2) sampler_.move(aimed, 1.0);
    return aimed;
  }

  void drive(const Candidate& candidate, const DriveStart& start,
             std::vector<TrajectoryPoint>& points) const {
    if (candidate.is_quintic) {
      driveQuintic(start, candidate.aimed.arrival, points);
    } else {
      bicycle_.roll(start, candidate.knots, candidate.aimed.arrival.time, points);
    }
    if (candidate.contender->driver) follow(*candidate.contender, points);
  }

  /// Drives along the points within the limits of the vehicle's class.
  static void follow(const Contender& contender, std::vector<TrajectoryPoint>& points) {
    std::vector<PlannedStep> plan;
    plan.reserve(points.size());
    for (const TrajectoryPoint& point : points) plan.push_back({point.pose, point.speed});
    contender.driver->drive(contender.drive_start, contender.start.now, plan, points);
  }

  bool keepsItsLimits(const Contender& contender, double until) const {
    if (!contender.driver) {
      return keepsLimits(points_, contender.start.motion.pose.yaw, until, limits_);
    }
    return !findBrokenDrive(points_, contender.drive_start, until, contender.limits);
  }

  /// Drives and scores the candidate, and keeps it if it is among the best of its family.
  void consider(Candidate& candidate) {
    const DriveStart& start = candidate.contender->start;
    candidate.score = {};
    drive(candidate, start, points_);
    const double until = start.now + input_.request.tta + input_.request.crash.time_tolerance;
    if (!keepsItsLimits(*candidate.contender, until)) return;
    candidate.score = scorer_.score(*candidate.contender->track, points_, candidate.aim->ego);
    candidate.objective = candidate.score.share + kClosenessWeight * candidate.score.closeness -
                          (input_.exact ? 1.0 : kPatternWeight) * missCost(candidate);
    std::vector<Candidate>& kept = candidate.is_quintic ? quintics_ : bicycles_;
    const bool full = static_cast<int>(kept.size()) >= search_.kept;
    if (full && candidate.objective < kept.back().objective) return;
    const BoxSize& size = candidate.contender->track->size;
    if (ground_.crossesKerb(points_, size)) return;
    const double arrival = start.now + input_.request.tta;
    candidate.off_road = ground_.offRoadShare(points_, arrival, size);
    candidate.steering = fastestSteering(points_, arrival, limits_);
    candidate.objective -= search_.off_road_weight * candidate.off_road +
                           kEffortWeight * effort(points_, arrival, limits_) +
                           search_.steering_weight * beyond(candidate.steering);
    if (input_.request.crash.believable) candidate.objective -= roadUsePenalty(candidate);
    kept.insert(std::upper_bound(kept.begin(), kept.end(), candidate, better), candidate);
    if (static_cast<int>(kept.size()) > search_.kept) kept.pop_back();
  }

  /// Returns the penalty for the candidate's road use; sets meets_constraints.
  double roadUsePenalty(Candidate& candidate) {
    const BelievabilityOptions& believability = options_.verification.believability;
    const Track& track = *candidate.contender->track;
    const LaneIndex& lanes = drivenLanes(input_.request, input_.lanes);
    const double contact = candidate.contender->start.now + candidate.aimed.contact;
    const RoadUse road = roadUseOfAttack(points_, track.size, contact, lanes, believability);
    candidate.meets_constraints =
        implausibilityOf(road, points_, track.size, contact, lanes, believability).empty() &&
        (candidate.score.share == 0.0 || constraints_.holds(track, points_, candidate.score.met));
    return kOffLaneWeight * (1.0 - road.on_lane) + kWrongWayWeight * road.wrong_way +
           (candidate.meets_constraints ? 0.0 : kConstraintPenalty);
  }

  /// Compares the contact with the pattern. Returns 0 within the pattern's tolerance, towards 1 far
  /// away, 1 without a contact.
  double missCost(Candidate& candidate) const {
    if (candidate.score.share == 0.0) return 1.0;
    candidate.miss = missBetween(candidate.aim->pattern->attacker_offset, candidate.score.contact);
    const double miss = beyondTolerance(candidate);
    return miss / (miss + kNearPattern);
  }

  double beyondTolerance(const Candidate& candidate) const {
    return candidate.aim->missedBy(candidate.miss, candidate.contender->track->size, input_.exact);
  }

  /// Returns the penalty for steering: 0 up to the configured rate, towards 1 far above it.
  double beyond(double steering) const {
    return 1.0 - kQuickSteering / std::max(kQuickSteering, steering);
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
             kept.front().steering <= search_.good_steering && kept.front().meets_constraints &&
             (input_.exact ? isExact(kept.front().miss)
                           : beyondTolerance(kept.front()) <= kExactDistance);
    };
    return good(quintics_) || good(bicycles_);
  }

  /// Perturbs the kept candidates, better ones more often.
  void perturb(const std::vector<Candidate>& kept, int count, double scale) {
    const std::vector<Candidate> parents = kept;
    if (parents.empty()) return;
    for (int i = 0; i < count && !isGood(); ++i) {
      const std::size_t rank =
          std::min(random_.index(parents.size()), random_.index(parents.size()));
      Candidate candidate = parents[rank];
      if (candidate.is_quintic) {
        sampler_.move(candidate.aimed, scale);
      } else {
        moveKnots(candidate.knots, scale);
      }
      consider(candidate);
    }
  }

  void moveKnots(SteeringKnots& knots, double scale) {
    for (double& knot : knots.acceleration) knot += random_.bell(1.2 * scale);
    for (double& knot : knots.curvature) knot += random_.bell(0.02 * scale);
  }

  /// Shifts the aims of the best candidates by the error of their contacts.
  void correctContacts() {
    std::vector<Candidate> parents = best();
    parents.resize(
        std::min(parents.size(), static_cast<std::size_t>(search_.corrected_candidates)));
    for (Candidate& candidate : parents) {
      for (int i = 0; i < search_.corrections && candidate.score.share > 0.0; ++i) {
        const Pose2& wanted = candidate.aim->touching;
        const Pose2& met = candidate.score.contact;
        if (cornerMiss(missBetween(wanted, met), candidate.contender->track->size) < kOnPattern)
          break;
        sampler_.shift(candidate.aimed,
                       {wanted.x - met.x, wanted.y - met.y, angleBetween(met.yaw, wanted.yaw)});
        if (candidate.is_quintic || solve(candidate)) consider(candidate);
      }
    }
  }

  /// Steers the bicycle to the candidate's arrival.
  bool solve(Candidate& candidate) const {
    const auto knots = bicycle_.solve(candidate.contender->start, candidate.aimed.arrival);
    if (knots) candidate.knots = *knots;
    return knots.has_value();
  }

  /// Steers the bicycle to arrivals, cycling through the attackers.
  void steerToArrivals() {
    std::vector<const Contender*> reachable;
    for (const auto& contender : contenders_) {
      if (sampler_.canReach(*contender)) reachable.push_back(contender.get());
    }
    if (reachable.empty()) return;
    for (int i = 0; i < search_.bicycle_targets && !isGood(); ++i) {
      const auto turn = static_cast<std::size_t>(i);
      const Contender& contender = *reachable[turn % reachable.size()];
      const std::size_t own_turn = turn / reachable.size();
      const Aim& aim = contender.aims[own_turn % contender.aims.size()];
      Candidate candidate = candidateFor(contender, aim);
      candidate.aimed = own_turn < contender.aims.size() ? sampler_.own(contender, aim, true)
                                                         : sampler_.wide(contender, aim, false);
      if (solve(candidate)) consider(candidate);
    }
  }

  /// Steers each attacker's bicycle to the ego in the future of its best pattern, with any contact
  /// of the type.
  void steerToContact() {
    const double end = sampler_.latest();
    SteeringAim aim;
    aim.ego_size = input_.snapshot.ego.size;
    aim.band = input_.request.bands();
    aim.first_in_time = sampler_.earliest();
    aim.last_in_time = end;
    aim.depth = kContactDepth;
    const int steps = static_cast<int>(std::ceil(end / SteeringSearch::kStep));
    std::vector<std::pair<const Contender*, SteeringSearch>> searches;
    for (const auto& contender : contenders_) {
      if (!sampler_.canReach(*contender)) continue;
      aim.ego.clear();
      for (int i = 0; i <= steps; ++i) {
        aim.ego.push_back(sampler_.egoAt(contender->aims.front().ego, end * i / steps));
      }
      aim.attacker_size = contender->track->size;
      searches.emplace_back(contender.get(), SteeringSearch(contender->start, aim, limits_));
    }
    for (int round = 0; round < search_.steering_rounds && !isGood(); ++round) {
      for (auto& [contender, search] : searches) {
        if (round >= kPatience && search.shortfall() > kHopeless) continue;
        Candidate candidate = candidateFor(*contender, contender->aims.front());
        candidate.aimed.ego = candidate.aim->ego;
        candidate.aimed.arrival.time = candidate.aimed.contact = end;
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
    found.pattern = candidate.aim->pattern;
    found.miss = candidate.miss;
    for (const std::size_t i : scorer_.hits(*found.attacker, found.points, found.score.met)) {
      found.hits.push_back(input_.egos[i]);
    }
    return found;
  }

  const SearchInput& input_;
  const AttackOptions& options_;
  SearchOptions search_;
  VehicleLimits limits_;
  BicycleFamily bicycle_;
  FutureScorer scorer_;
  GroundUse ground_;
  std::vector<std::unique_ptr<Contender>> contenders_;
  RequestConstraints constraints_;
  Random random_;
  ArrivalSampler sampler_;
  std::vector<Candidate> quintics_;  // best first
  std::vector<Candidate> bicycles_;  // best first
  std::vector<TrajectoryPoint> points_;
};

}  // namespace

std::vector<FoundAttack> searchAttacks(const SearchInput& input, const AttackOptions& options) {
  if (input.isByRoutes()) return searchManoeuvres(input, options);
  return Search(input, options).run();
}

}  // namespace forge
