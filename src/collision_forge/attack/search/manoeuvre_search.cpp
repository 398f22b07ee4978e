#include "collision_forge/attack/search/manoeuvre_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/arrival_sampler.h"
#include "collision_forge/attack/search/conduct.h"
#include "collision_forge/attack/search/contender.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/request_constraints.h"
#include "collision_forge/attack/search/route_drafts.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/reversing.h"

namespace forge {
namespace {

constexpr double kContacts[] = {0.0, -0.25, 0.25};  // s, added to the requested time
constexpr double kOffRoadWeight =
    1.0;                         // cost of a wholly off-road drive, as a share of the futures
constexpr double kShrink = 0.7;  // factor on perturbations per round

struct Candidate {
  const Contender* contender = nullptr;
  const RouteDriver* route = nullptr;
  RouteDraft draft;
  const Aim* aim = nullptr;
  FutureScore score;
  PatternMiss miss;
  RoadVerdict verdict;
  std::size_t style = 0;
  double objective = 0.0;
  bool is_underway = false;  // the attacker's current plan, not a draft
};

class ManoeuvreSearch {
 public:
  ManoeuvreSearch(const SearchInput& input, const AttackOptions& options)
      : input_(input),
        search_(options.search),
        route_(options.route),
        constraints_(input, options),
        drafts_(input),
        scorer_(input.egos, input.future.agents, input.request, input.snapshot.now,
                input.lanes.map().driving_side, options),
        contenders_(contendersOf(input, options, options.verification.limits, scorer_.steps())),
        random_(input.request.seed),
        sampler_(input, options, options.verification.limits, random_) {
    const double end = input.request.tta + search_.tail;
    all_points_ = std::max(static_cast<std::size_t>(scorer_.steps()),
                           static_cast<std::size_t>(std::lround(end / search_.step)) + 1);
  }

  std::vector<FoundAttack> run() {
    if (input_.underway != nullptr && !contenders_.empty()) scoreCurrentPlan();
    if (!isGood()) draft();
    for (int round = 0; round < route_.rounds && !isGood(); ++round) {
      perturb(std::pow(kShrink, round));
    }
    std::vector<FoundAttack> found;
    for (const Candidate& candidate : kept_) {
      if (candidate.is_underway) continue;
      if (candidate.score.share > 0.0 || current_plan_) found.push_back(finished(candidate));
    }
    if (current_plan_) found.push_back(finished(*current_plan_));
    return found;
  }

 private:
  /// Scores the current plan, and the same draft at each of the ego's positions.
  void scoreCurrentPlan() {
    Candidate candidate;
    candidate.contender = contenders_.front().get();
    candidate.route = &contenders_.front()->routes.front();
    candidate.is_underway = true;
    candidate.style = input_.underway->style;
    candidate.draft = input_.underway->draft.value_or(RouteDraft{});
    if (!input_.underway->draft) candidate.draft.contact = input_.request.tta;
    points_ = input_.underway->planned;
    judge(candidate);
    current_plan_ = candidate;
    if (!input_.underway->draft || isGood()) return;
    candidate.is_underway = false;
    for (const std::size_t ego : sampler_.egos()) {
      for (const double early : kContacts) {
        candidate.draft = *input_.underway->draft;
        candidate.draft.ego = ego;
        candidate.draft.contact =
            std::clamp(candidate.draft.contact + early, sampler_.earliest(), sampler_.latest());
        consider(candidate);
      }
    }
  }

  /// With many contenders: one draft each, then all drafts of the best ones.
  void draft() {
    const auto most = static_cast<std::size_t>(kDrafted);
    std::vector<std::pair<double, const Contender*>> ranked;
    sketches_ = contenders_.size() > most;
    for (const auto& contender : contenders_) {
      best_ = -std::numeric_limits<double>::infinity();
      if (sketches_) draftFor(*contender);
      ranked.emplace_back(best_, contender.get());
    }
    has_sketches_ = sketches_;
    sketches_ = false;
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    ranked.resize(std::min(most, ranked.size()));
    for (const auto& [best, contender] : ranked) draftFor(*contender);
  }

  /// Scores the drafts to which a contender's routes lead, in this pass.
  void draftFor(const Contender& contender) {
    const double meant = contender.aims.front().pattern->time - input_.snapshot.now;
    const bool has_way = input_.ways.count(contender.track->id) > 0;
    const bool is_new = input_.underway == nullptr;
    for (const RouteDriver& route : contender.routes) {
      for (const std::size_t ego : sampler_.egos()) {
        for (const double early : kContacts) {
          if (is_new && isGood()) return;
          const double contact = std::clamp(meant + early, sampler_.earliest(), sampler_.latest());
          draftAt(contender, route, ego, contact);
          // A new attack tries other contact times against the first of the ego's futures alone. A
          // vehicle that was added for this contact time tries no other.
          if (has_way || (is_new && ego != sampler_.egos().front())) break;
        }
      }
    }
  }

  void draftAt(const Contender& contender, const RouteDriver& route, std::size_t ego,
               double contact) {
    const Pose2 pose = sampler_.egoAt(ego, contact);
    const PathPose seen = route.path().frenetOf(pose);
    const double reach =
        circumradius(input_.snapshot.ego.size) + circumradius(contender.track->size);
    if (std::abs(seen.across) > kRouteReach || seen.along < route.start().along - reach) return;
    // In a bend, the paths to the ego and to the attacker's pose differ.
    const Pose2 meant = compose(pose, contender.aims.front().pattern->attacker_offset);
    const bool has_way = input_.ways.count(contender.track->id) > 0;
    const double there = has_way ? route.path().project(meant.position()) : seen.along;
    const double direction = angleBetween(pose.yaw, route.path().at(there).pose.yaw);
    Candidate candidate;
    candidate.contender = &contender;
    candidate.route = &route;
    candidate.draft.ego = ego;
    candidate.draft.contact = contact;
    for (const HeadedPlacement& placement :
         placementsAlong(direction, input_.request, input_.lanes.map().driving_side,
                         kArrivalHeadingMargin, kMaxLean)) {
      candidate.draft.side = placement.side;
      candidate.draft.heading = placement.heading;
      const std::vector<RouteDraft> drafts =
          drafts_.mannersFor(candidate.draft, contender, there - route.start().along);
      const std::vector<double>& positions = drafts_.contactPositions();
      for (std::size_t position = 0; position < positions.size(); ++position) {
        for (std::size_t i = 0; i < drafts.size(); ++i) {
          if (!isInThisPass(position == RouteDrafts::kFirstPosition, i)) continue;
          candidate.draft = drafts[i];
          candidate.draft.contact_position = positions[position];
          consider(candidate);
        }
      }
    }
  }

  /// Returns true if the draft belongs to this pass: first one draft per vehicle, then variations
  /// in one parameter. Few vehicles get all drafts at once.
  bool isInThisPass(bool is_first_position, std::size_t manner) const {
    const bool is_first = is_first_position && manner == 0;
    if (sketches_) return is_first;
    if (input_.underway != nullptr) return is_first_position || manner == 0;
    return !has_sketches_ || (!is_first && (is_first_position || manner == 0));
  }

  /// Plans and drives the draft; returns false if the route does not lead there.
  bool planOf(const Candidate& candidate, std::size_t count, std::size_t& style) {
    const RouteDraft& draft = candidate.draft;
    const Contender& contender = *candidate.contender;
    const Pose2 offset = attackerOffset(input_.snapshot.ego.size, contender.track->size, draft.side,
                                        draft.heading, draft.contact_position, kContactDepth);
    const Pose2 target = compose(sampler_.egoAt(draft.ego, draft.contact), offset);
    RoutePlan plan;
    plan.arrival = draft.contact;
    plan.at = candidate.route->path().frenetOf(target);
    plan.departure = draft.departure;
    plan.lead = draft.lead;
    plan.late = draft.late;
    plan.late_acceleration = draft.late_acceleration;
    plan.wait = draft.wait;
    if (plan.at.along < candidate.route->start().along - kArrivalPrecision ||
        std::abs(plan.at.lean) > kMaxLean || std::abs(plan.at.across) > kMaxDeparture) {
      return false;
    }
    const auto& speed = driveAlong(*candidate.route, plan);
    if (!speed) return false;
    style = speed->style;
    candidate.route->plan(plan, course_, search_.step, count, planned_);
    contender.driver->drive(contender.drive_start, input_.snapshot.now, planned_, points_);
    if (input_.request.reverses()) turnRound(points_);
    return true;
  }

  /// Returns the plan's speed and sets course_. Caches the last result: consecutive drafts often
  /// differ only across the route.
  const std::optional<RouteSpeed>& driveAlong(const RouteDriver& route, const RoutePlan& plan) {
    const bool is_same = last_route_ == &route && last_plan_.arrival == plan.arrival &&
                         last_plan_.at.along == plan.at.along && last_plan_.late == plan.late &&
                         last_plan_.late_acceleration == plan.late_acceleration &&
                         last_plan_.wait == plan.wait;
    if (is_same) return last_speed_;
    last_route_ = &route;
    last_plan_ = plan;
    RouteReach& reach =
        reaches_[{&route, plan.arrival, plan.late, plan.late_acceleration, plan.wait}];
    last_speed_ = route.speedFor(plan, search_.step, reach);
    if (last_speed_) course_ = route.courseAt(plan, *last_speed_, search_.step);
    return last_speed_;
  }

  void consider(Candidate& candidate) {
    const auto steps = static_cast<std::size_t>(scorer_.steps());
    if (planOf(candidate, steps, candidate.style)) judge(candidate);
  }

  /// Scores the candidate, whose motion is in points_, and keeps it if it is one of the best.
  void judge(Candidate& candidate) {
    candidate.score = {};
    const Contender& contender = *candidate.contender;
    candidate.aim = nearestAim(candidate);
    candidate.score = scorer_.score(*contender.track, points_, candidate.draft.ego);
    candidate.objective = candidate.score.share + kClosenessWeight * candidate.score.closeness -
                          kPatternWeight * missCost(candidate) - effortOf(candidate);
    best_ = std::max(best_, candidate.objective);
    const bool full = static_cast<int>(kept_.size()) >= search_.kept;
    if (full && candidate.objective < kept_.back().objective) return;
    const double now = input_.snapshot.now;
    const double until = now + input_.request.tta + input_.request.crash.time_tolerance;
    // The current plan is kept for comparison whatever its limits.
    const bool may_be_any = candidate.is_underway;
    if (input_.request.reverses()) turnRound(points_);
    const auto broken = findBrokenDrive(points_, contender.drive_start, until, contender.limits);
    if (input_.request.reverses()) turnRound(points_);
    if (broken && !may_be_any) return;
    candidate.verdict =
        contender.conduct->judge(whole(), contender.track->size, now + candidate.draft.contact);
    const RoadUse& road = candidate.verdict.road;
    candidate.objective -= kOffLaneWeight * (1.0 - road.on_lane) + kOffRoadWeight * road.off_road +
                           kWrongWayWeight * road.wrong_way;
    if (road.on_walkway > 0.0 && !input_.request.reverses() && !may_be_any) return;
    if ((!candidate.verdict.is_believable && !may_be_any) || !meetsRequest(candidate)) {
      candidate.objective -= kConstraintPenalty;
    }
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate, better), candidate);
    if (static_cast<int>(kept_.size()) > search_.kept) kept_.pop_back();
  }

  /// With constraints, an attacker underway must not change to a plan without a hit.
  bool meetsRequest(const Candidate& candidate) {
    if (!constraints_.isNamed()) return true;
    if (candidate.score.share == 0.0) return input_.underway == nullptr;
    return constraints_.holds(*candidate.contender->track, whole(), candidate.score.met);
  }

  /// Returns points_ preceded by the motion driven before.
  const std::vector<TrajectoryPoint>& whole() {
    if (input_.underway == nullptr) return points_;
    whole_ = input_.underway->driven;
    whole_.insert(whole_.end(), points_.begin(), points_.end());
    return whole_;
  }

  /// Returns the contender's pattern nearest to the draft's contact.
  const Aim* nearestAim(const Candidate& candidate) const {
    const Contender& contender = *candidate.contender;
    Pose2 offset =
        attackerOffset(input_.snapshot.ego.size, contender.track->size, candidate.draft.side,
                       candidate.draft.heading, candidate.draft.contact_position, 0.0);
    if (input_.request.reverses()) offset = turnedRound(offset);
    const auto apart = [&](const Aim& aim) {
      return cornerMiss(missBetween(aim.pattern->attacker_offset, offset), contender.track->size);
    };
    return &*std::min_element(contender.aims.begin(), contender.aims.end(),
                              [&](const Aim& a, const Aim& b) { return apart(a) < apart(b); });
  }

  double missCost(Candidate& candidate) const {
    if (candidate.score.share == 0.0) return 1.0;
    candidate.miss = missBetween(candidate.aim->pattern->attacker_offset, candidate.score.contact);
    const double miss =
        candidate.aim->missedBy(candidate.miss, candidate.contender->track->size, input_.exact);
    return miss / (miss + kNearPattern);
  }

  /// For a plan underway without a draft only the total effort is known; it counts for at most the
  /// cost of leaving the lane now.
  double effortOf(const Candidate& candidate) const {
    const double contact = candidate.draft.contact;
    const Conduct& conduct = *candidate.contender->conduct;
    if (candidate.is_underway && !input_.underway->draft) {
      return std::min(input_.underway->effort, conduct.departureCost(contact));
    }
    return kDrivingStyles[candidate.style].cost +
           conduct.departureCost(std::min(candidate.draft.departure, contact));
  }

  static bool better(const Candidate& a, const Candidate& b) { return a.objective > b.objective; }

  bool isGood() const {
    return !kept_.empty() && kept_.front().score.share >= search_.good_share &&
           (kept_.front().style == 0 || kept_.front().is_underway) &&
           (!constraints_.isNamed() || kept_.front().objective > 0.0) &&
           kept_.front().verdict.is_believable && kept_.front().verdict.road.on_lane >= 1.0 &&
           kept_.front().verdict.road.off_road <= search_.good_off_road &&
           (!input_.exact || isExact(kept_.front().miss));
  }

  /// Perturbs the kept candidates, better ones more often.
  void perturb(double scale) {
    // A plan without a draft cannot be perturbed.
    const bool may_move = input_.underway == nullptr || input_.underway->draft.has_value();
    std::vector<Candidate> parents;
    std::copy_if(kept_.begin(), kept_.end(), std::back_inserter(parents),
                 [=](const Candidate& kept) { return may_move || !kept.is_underway; });
    if (parents.empty()) return;
    for (int i = 0; i < route_.perturbations && !isGood(); ++i) {
      const std::size_t rank =
          std::min(random_.index(parents.size()), random_.index(parents.size()));
      Candidate candidate = parents[rank];
      candidate.is_underway = false;
      drafts_.perturb(candidate.draft, scale, {sampler_.earliest(), sampler_.latest()},
                      search_.step, random_);
      consider(candidate);
    }
  }

  FoundAttack finished(const Candidate& candidate) {
    FoundAttack found;
    found.attacker = candidate.contender->track;
    found.is_underway = candidate.is_underway;
    if (candidate.is_underway) {
      found.points = input_.underway->planned;
    } else {
      std::size_t style = 0;
      planOf(candidate, all_points_, style);
      found.points = points_;
    }
    found.score = candidate.score;
    found.off_road = candidate.verdict.road.off_road;
    found.drafted = DraftedPath{candidate.route->path(), candidate.draft, candidate.style};
    found.objective = candidate.objective;
    found.effort = effortOf(candidate);
    found.pattern = candidate.aim->pattern;
    found.miss = candidate.miss;
    for (const std::size_t i : scorer_.hits(*found.attacker, found.points, found.score.met)) {
      found.hits.push_back(input_.egos[i]);
    }
    return found;
  }

  const SearchInput& input_;
  const SearchOptions& search_;
  const RouteDriverOptions& route_;
  RequestConstraints constraints_;
  RouteDrafts drafts_;
  FutureScorer scorer_;
  std::vector<std::unique_ptr<Contender>> contenders_;
  Random random_;
  ArrivalSampler sampler_;
  std::size_t all_points_ = 0;
  bool sketches_ = false;                  // this pass: one draft per contender
  bool has_sketches_ = false;              // that pass was done
  double best_ = 0.0;                      // best objective of the contender's drafts so far
  std::vector<Candidate> kept_;            // best first
  std::optional<Candidate> current_plan_;  // the attacker's current plan
  const RouteDriver* last_route_ = nullptr;
  RoutePlan last_plan_;
  std::optional<RouteSpeed> last_speed_;
  RouteCourse course_;
  // By route and the inputs of RouteDriver::speedFor().
  std::map<std::tuple<const RouteDriver*, double, double, double, double>, RouteReach> reaches_;
  std::vector<PlannedStep> planned_;
  std::vector<TrajectoryPoint> points_;
  std::vector<TrajectoryPoint> whole_;
};

}  // namespace

std::vector<FoundAttack> searchManoeuvres(const SearchInput& input, const AttackOptions& options) {
  return ManoeuvreSearch(input, options).run();
}

}  // namespace forge
