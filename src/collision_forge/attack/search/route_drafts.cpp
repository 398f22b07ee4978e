#include "collision_forge/attack/search/route_drafts.h"

#include <algorithm>
#include <iterator>

#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/search/request_constraints.h"

namespace forge {
namespace {

// Values of RouteDraft that are tried for every attacker, chosen on recorded scenes
// (docs/results.md).
constexpr double kDepartures[] = {1.0, 1.4, 0.8, 2.2, 3.0};  // s, RoutePlan::departure
constexpr double kLeads[] = {0.0, 0.5};                      // s, RoutePlan::lead
constexpr double kLateBraking[] = {0.0, 3.0, 5.0};           // m/s2, late deceleration of a leader
constexpr double kContactPositions[] = {-0.7, 0.0, 0.7};

std::vector<double> ascendingIn(const Range& range) {
  auto values = valuesTriedIn(range);
  std::sort(values.begin(), values.end());
  return {values.begin(), values.end()};
}

}  // namespace

RouteDrafts::RouteDrafts(const SearchInput& input)
    : input_(input),
      contact_positions_(std::begin(kContactPositions), std::end(kContactPositions)),
      position_range_{-kMaxContactPosition, kMaxContactPosition},
      brakings_(std::begin(kLateBraking), std::end(kLateBraking)) {
  const CollisionRequest& request = input.request;
  if (const std::optional<Range>& location = request.impact_location) {
    position_range_ = {contactPositionOf(location->max), contactPositionOf(location->min)};
    contact_positions_ = ascendingIn(position_range_);
  }
  if (request.deceleration) brakings_ = ascendingIn(*request.deceleration);
  if (request.departure_time) {
    const double since =
        input.underway != nullptr ? input.snapshot.now - input.underway->start.now : 0.0;
    wait_range_ = Range{std::max(0.0, request.departure_time->min - since),
                        std::max(0.0, request.departure_time->max - since)};
  }
}

void RouteDrafts::addStandingStarts(RouteDraft draft, const Contender& contender, double distance,
                                    std::vector<RouteDraft>& drafts) const {
  std::vector<double> starts = contender.conduct->startsBefore(distance);
  if (wait_range_) {
    starts.clear();
    for (const double wait : valuesTriedIn(*wait_range_)) starts.push_back(draft.contact - wait);
  }
  for (const double start : starts) {
    draft.wait = draft.contact - start;
    if (draft.wait <= 0.0 || start <= 0.0) continue;
    draft.departure = start;
    drafts.push_back(draft);
  }
}

std::vector<RouteDraft> RouteDrafts::mannersFor(const RouteDraft& meeting,
                                                const Contender& contender, double distance) const {
  RouteDraft draft;
  draft.ego = meeting.ego;
  draft.contact = meeting.contact;
  draft.side = meeting.side;
  draft.heading = meeting.heading;
  const CollisionType type = input_.request.type;
  std::vector<RouteDraft> drafts;
  if (contender.drive_start.speed <= 0.0) {
    addStandingStarts(draft, contender, distance, drafts);
    if (wait_range_ && wait_range_->max > 0.0) return drafts;
  }
  const bool may_brake = input_.request.deceleration ||
                         (type == CollisionType::kRearEnd && draft.side == Side::kFront);
  for (const double departure : kDepartures) {
    draft.departure = departure;
    if (!may_brake) {
      for (const double lead : kLeads) {
        draft.lead = lead;
        drafts.push_back(draft);
        // For all other types, a heading difference of a few degrees is part of the contact.
        if (type != CollisionType::kOppositeDirection) break;
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

void RouteDrafts::perturb(RouteDraft& draft, double scale, const Range& contacts, double step,
                          Random& random) const {
  draft.contact = std::clamp(draft.contact + random.bell(0.15 * scale), contacts.min, contacts.max);
  draft.contact_position = std::clamp(draft.contact_position + random.bell(0.4 * scale),
                                      position_range_.min, position_range_.max);
  draft.heading = wrapAngle(draft.heading + random.bell(0.05 * scale));
  draft.departure = std::max(step, draft.departure + random.bell(0.4 * scale));
  draft.lead = std::max(0.0, draft.lead + random.bell(0.2 * scale));
  if (draft.wait > 0.0) {
    draft.wait = std::max(0.0, draft.wait + random.bell(0.3 * scale));
    if (wait_range_) draft.wait = std::clamp(draft.wait, wait_range_->min, wait_range_->max);
  }
  if (draft.late > 0.0) {
    draft.late = std::max(step, draft.late + random.bell(0.3 * scale));
    draft.late_acceleration = std::min(0.0, draft.late_acceleration + random.bell(1.0 * scale));
  }
}

}  // namespace forge
