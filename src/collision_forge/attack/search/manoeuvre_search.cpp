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
#include "collision_forge/attack/search/contender.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/request_constraints.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/step_out.h"

namespace forge {
namespace {

// Values of RouteDraft that are tried for every attacker, chosen on recorded scenes
// (docs/results.md).
constexpr double kContacts[] = {0.0, -0.25, 0.25};           // s, added to the requested time
constexpr double kDepartures[] = {1.0, 1.4, 0.8, 2.2, 3.0};  // s, RoutePlan::departure
constexpr double kLeads[] = {0.0, 0.5};                      // s, RoutePlan::lead
constexpr double kLateBraking[] = {0.0, 3.0, 5.0};           // m/s2, late deceleration of a leader
constexpr double kStarts[] = {1.6, 2.3, 3.2};  // s before the contact at which a standing
                                               // attacker starts
// m/s of a pedestrian who steps out: walking, fast and running; recorded walkers have 1.24.
constexpr double kWalkingSpeeds[] = {1.3, 1.7, 2.4};
constexpr double kWalkingAcceleration = 1.0;  // m/s2, Euro NCAP's walker
// Costs, as shares of the futures:
constexpr double kDepartureWeight = 0.2;  // per second off the lane before before_contact of
                                          // config/believability.yaml
constexpr double kOffRoadWeight = 1.0;    // of a wholly off-road drive
constexpr double kContactPositions[] = {-0.7, 0.0, 0.7};
constexpr std::size_t kFirstPosition = 1;  // index of the contact position that is drafted first
constexpr double kShrink = 0.7;            // factor on perturbations per round

struct Candidate {
  const Contender* contender = nullptr;
  const RouteDriver* route = nullptr;
  RouteDraft draft;
  const Aim* aim = nullptr;
  FutureScore score;
  PatternMiss miss;
  RoadUse road;
  bool is_believable = true;  // judged by the road use
  std::size_t style = 0;
  double objective = 0.0;
  bool is_underway = false;  // the attacker's current plan, not a draft
};

class ManoeuvreSearch {
 public:
  ManoeuvreSearch(const SearchInput& input, const AttackOptions& options)
      : input_(input),
        driven_(drivenLanes(input.request, input.lanes)),
        options_(options),
        search_(options.search),
        route_(options.route),
        constraints_(input, options),
        scorer_(input.egos, input.future.agents, input.request, input.snapshot.now,
                input.lanes.map().driving_side, options),
        contenders_(contendersOf(input, options, options.verification.limits, scorer_.steps())),
        random_(input.request.seed),
        sampler_(input, options, options.verification.limits, random_) {
    const double end = input.request.tta + search_.tail;
    setRanges();
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
  /// Sets the drafted contact positions, late braking and waits, from the requested ranges if there
  /// are any.
  void setRanges() {
    const CollisionRequest& request = input_.request;
    contact_positions_.assign(std::begin(kContactPositions), std::end(kContactPositions));
    brakings_.assign(std::begin(kLateBraking), std::end(kLateBraking));
    if (const std::optional<Range>& location = request.impact_location) {
      position_range_ = {contactPositionOf(location->max), contactPositionOf(location->min)};
      contact_positions_ = ascendingIn(position_range_);
    }
    if (request.deceleration) brakings_ = ascendingIn(*request.deceleration);
    if (request.departure_time) {
      const double since =
          input_.underway != nullptr ? input_.snapshot.now - input_.underway->start.now : 0.0;
      wait_range_ = Range{std::max(0.0, request.departure_time->min - since),
                          std::max(0.0, request.departure_time->max - since)};
    }
  }

  static std::vector<double> ascendingIn(const Range& range) {
    auto values = valuesTriedIn(range);
    std::sort(values.begin(), values.end());
    return {values.begin(), values.end()};
  }

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
    const PathPose seen = route.path().seen(pose);
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
      const std::vector<RouteDraft> drafts = mannersFor(candidate, there - route.start().along);
      for (std::size_t position = 0; position < contact_positions_.size(); ++position) {
        for (std::size_t i = 0; i < drafts.size(); ++i) {
          if (!isInThisPass(position == kFirstPosition, i)) continue;
          candidate.draft = drafts[i];
          candidate.draft.contact_position = contact_positions_[position];
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

  /// Returns drafts with different departures and, if the ego runs into the attacker or the request
  /// has a deceleration, late braking.
  /// `distance`: m along the route to the meeting.
  std::vector<RouteDraft> mannersFor(const Candidate& candidate, double distance) const {
    std::vector<RouteDraft> drafts;
    RouteDraft draft;
    draft.ego = candidate.draft.ego;
    draft.contact = candidate.draft.contact;
    draft.side = candidate.draft.side;
    draft.heading = candidate.draft.heading;
    const bool may_brake =
        input_.request.deceleration ||
        (input_.request.type == CollisionType::kRearEnd && draft.side == Side::kFront);
    const bool is_standing = candidate.contender->drive_start.speed <= 0.0;
    for (const double start : startsOf(candidate, distance)) {
      draft.wait = draft.contact - start;
      if (!is_standing || draft.wait <= 0.0) break;
      draft.departure = start;
      drafts.push_back(draft);
    }
    if (wait_range_ && wait_range_->max > 0.0 && is_standing) return drafts;
    draft.wait = 0.0;
    for (const double departure : kDepartures) {
      draft.departure = departure;
      if (!may_brake) {
        for (const double lead : kLeads) {
          draft.lead = lead;
          drafts.push_back(draft);
          // For all other types, a heading difference of a few degrees is part of the contact.
          if (input_.request.type != CollisionType::kOppositeDirection) break;
        }
        continue;
      }
      for (const double braking : brakings_) {
        draft.late = braking > 0.0 ? departure : 0.0;
        draft.late_acceleration = -braking;
        drafts.push_back(draft);
      }
    }
    return drafts;
  }

  /// Returns how long (s) before the contact a standing attacker moves off.
  std::vector<double> startsOf(const Candidate& candidate, double distance) const {
    std::vector<double> starts;
    if (wait_range_) {
      for (const double wait : valuesTriedIn(*wait_range_)) {
        if (wait < candidate.draft.contact) starts.push_back(candidate.draft.contact - wait);
      }
      return starts;
    }
    if (!isWalker(*candidate.contender)) return {std::begin(kStarts), std::end(kStarts)};
    for (const double speed : kWalkingSpeeds) {
      starts.push_back(std::max(0.0, distance) / speed + 0.5 * speed / kWalkingAcceleration);
    }
    return starts;
  }

  static bool isWalker(const Contender& contender) {
    return contender.track->agent_class == AgentClass::kPedestrian;
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
    plan.at = candidate.route->path().seen(target);
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
    const auto broken = findBrokenDrive(points_, contender.drive_start, until, contender.limits);
    if (broken && !may_be_any) return;
    judgeRoad(candidate);
    candidate.objective -= kOffLaneWeight * (1.0 - candidate.road.on_lane) +
                           kOffRoadWeight * candidate.road.off_road +
                           kWrongWayWeight * candidate.road.wrong_way;
    if (candidate.road.on_walkway > 0.0 && !may_be_any) return;
    if ((!candidate.is_believable && !may_be_any) || !meetsRequest(candidate)) {
      candidate.objective -= kConstraintPenalty;
    }
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate, better), candidate);
    if (static_cast<int>(kept_.size()) > search_.kept) kept_.pop_back();
  }

  void judgeRoad(Candidate& candidate) {
    const BelievabilityOptions& believability = options_.verification.believability;
    const std::vector<TrajectoryPoint>& points = whole();
    const BoxSize& size = candidate.contender->track->size;
    const double contact = input_.snapshot.now + candidate.draft.contact;
    if (isWalker(*candidate.contender)) {
      candidate.road = {};
      candidate.road.on_lane = 1.0;  // lanes are not for pedestrians
      candidate.is_believable = !input_.request.crash.believable ||
                                implausibleWalk(stepOutOf(points, contact, input_.lanes)).empty();
      return;
    }
    candidate.road = roadUseOfAttack(points, size, contact, driven_, believability);
    candidate.is_believable =
        !input_.request.crash.believable ||
        implausibilityOf(candidate.road, points, size, contact, driven_, believability).empty();
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
    const Pose2 offset =
        attackerOffset(input_.snapshot.ego.size, contender.track->size, candidate.draft.side,
                       candidate.draft.heading, candidate.draft.contact_position, 0.0);
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

  /// Returns the cost of leaving the lane `departure` seconds before the contact.
  double departureCost(double departure) const {
    const double early = departure - options_.verification.believability.before_contact;
    return kDepartureWeight * std::max(0.0, early);
  }

  /// For a plan underway without a draft only the total effort is known; it counts for at most the
  /// cost of leaving the lane now.
  double effortOf(const Candidate& candidate) const {
    const double contact = candidate.draft.contact;
    if (candidate.is_underway && !input_.underway->draft) {
      return std::min(input_.underway->effort, departureCost(contact));
    }
    if (isWalker(*candidate.contender)) return kDrivingStyles[candidate.style].cost;
    return kDrivingStyles[candidate.style].cost +
           departureCost(std::min(candidate.draft.departure, contact));
  }

  static bool better(const Candidate& a, const Candidate& b) { return a.objective > b.objective; }

  bool isGood() const {
    return !kept_.empty() && kept_.front().score.share >= search_.good_share &&
           (kept_.front().style == 0 || kept_.front().is_underway) &&
           (!constraints_.isNamed() || kept_.front().objective > 0.0) &&
           kept_.front().is_believable && kept_.front().road.on_lane >= 1.0 &&
           kept_.front().road.off_road <= search_.good_off_road &&
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
      move(candidate.draft, scale);
      consider(candidate);
    }
  }

  void move(RouteDraft& draft, double scale) {
    draft.contact = std::clamp(draft.contact + random_.bell(0.15 * scale), sampler_.earliest(),
                               sampler_.latest());
    draft.contact_position = std::clamp(draft.contact_position + random_.bell(0.4 * scale),
                                        position_range_.min, position_range_.max);
    draft.heading = wrapAngle(draft.heading + random_.bell(0.05 * scale));
    draft.departure = std::max(search_.step, draft.departure + random_.bell(0.4 * scale));
    draft.lead = std::max(0.0, draft.lead + random_.bell(0.2 * scale));
    if (draft.wait > 0.0) {
      draft.wait = std::max(0.0, draft.wait + random_.bell(0.3 * scale));
      if (wait_range_) draft.wait = std::clamp(draft.wait, wait_range_->min, wait_range_->max);
    }
    if (draft.late > 0.0) {
      draft.late = std::max(search_.step, draft.late + random_.bell(0.3 * scale));
      draft.late_acceleration = std::min(0.0, draft.late_acceleration + random_.bell(1.0 * scale));
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
    found.off_road = candidate.road.off_road;
    found.drafted = DraftedWay{candidate.route->path(), candidate.draft, candidate.style};
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
  const LaneIndex& driven_;
  const AttackOptions& options_;
  const SearchOptions& search_;
  const RouteDriverOptions& route_;
  RequestConstraints constraints_;
  FutureScorer scorer_;
  std::vector<std::unique_ptr<Contender>> contenders_;
  Random random_;
  ArrivalSampler sampler_;
  std::vector<double> contact_positions_;  // drafted contact positions
  Range position_range_{-kMaxContactPosition, kMaxContactPosition};
  std::vector<double> brakings_;     // m/s2, drafted late braking
  std::optional<Range> wait_range_;  // s, for which a standing attacker waits
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
