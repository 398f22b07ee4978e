#include "collision_forge/attack/search/arrival_sampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "collision_forge/attack/search/placement.h"

namespace forge {
namespace {

constexpr double kMinArrival = 0.3;      // s after t0
constexpr double kMinImpactSpeed = 0.2;  // m/s
constexpr double kMaxDrawnSpeed = 15.0;  // m/s at the impact
constexpr double kNear = 6.0;            // m between vehicle centres within which boxes may touch

/// Returns true if the band includes 0 or pi, so that headings of both signs are allowed; otherwise
/// the pattern gives the sign.
bool isOneBand(const TypeDefinition& band) {
  return band.min_heading < kBandEnd || band.max_heading > M_PI - kBandEnd;
}

}  // namespace

std::vector<std::size_t> spreadFutures(const std::vector<const Track*>& egos, const Pose2& now,
                                       double time, int most) {
  std::vector<std::size_t> order(egos.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> along;
  for (const Track* ego : egos) {
    const Pose2 pose = stateAt(*ego, time).value_or(ego->states.back()).pose;
    along.push_back(relativeTo(now, pose).x);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
  const int count = std::min(most, static_cast<int>(order.size()));
  std::vector<std::size_t> spread;
  for (int i = 0; i < count; ++i) {
    const double rank = (i + 0.5) / count * static_cast<double>(order.size());
    spread.push_back(order[static_cast<std::size_t>(rank)]);
  }
  return spread;
}

ArrivalSampler::ArrivalSampler(const SearchInput& input, const AttackOptions& options,
                               const VehicleLimits& limits, Random& random)
    : input_(input), options_(options), limits_(limits), random_(random) {
  const double tta = input.request.tta;
  const double slack = input.request.crash.time_tolerance - options.search.time_margin;
  earliest_ = std::max(kMinArrival, tta - slack);
  latest_ = std::max(earliest_, tta + slack);
  egos_ = spreadFutures(input.egos, input.snapshot.ego.states.back().pose, input.snapshot.now + tta,
                        options.search.ego_poses);
}

Pose2 ArrivalSampler::egoAt(std::size_t ego, double seconds) const {
  const Track& track = *input_.egos[ego];
  return stateAt(track, input_.snapshot.now + seconds).value_or(track.states.back()).pose;
}

/// Returns the speed at the contact for which a constant acceleration covers the distance.
double ArrivalSampler::steadySpeed(const Contender& contender, const Pose2& target,
                                   double contact) const {
  const Motion& motion = contender.start.motion;
  const double distance = (target.position() - motion.pose.position()).norm();
  return std::clamp(2.0 * distance / contact - motion.speed, 0.5, limits_.max_speed);
}

/// Derives the arrival's time and pose from the contact.
void ArrivalSampler::settle(AimedArrival& aimed) const {
  aimed.contact = std::clamp(aimed.contact, earliest_, latest_);
  aimed.lead = std::clamp(aimed.lead, 0.0, aimed.contact - kMinArrival);
  Arrival& arrival = aimed.arrival;
  arrival.speed = std::clamp(arrival.speed, kMinImpactSpeed, limits_.max_speed);
  arrival.time = aimed.contact - aimed.lead;
  const Pose2 contact = compose(egoAt(aimed.ego, aimed.contact), aimed.offset);
  arrival.pose = compose(contact, {-arrival.speed * aimed.lead, 0.0, 0.0});
}

AimedArrival ArrivalSampler::own(const Contender& contender, const Aim& aim, bool steady) const {
  AimedArrival aimed;
  aimed.ego = aim.ego;
  aimed.offset = aim.touching;
  aimed.contact = std::clamp(aim.pattern->time - input_.snapshot.now, earliest_, latest_);
  aimed.arrival.speed = aim.pattern->attacker_speed;
  if (steady) {
    const Pose2 target = compose(egoAt(aimed.ego, aimed.contact), aimed.offset);
    aimed.arrival.speed = steadySpeed(contender, target, aimed.contact);
  }
  aimed.arrival.start_acceleration = std::clamp(contender.start.motion.acceleration, -3.0, 3.0);
  settle(aimed);
  return aimed;
}

AimedArrival ArrivalSampler::wide(const Contender& contender, const Aim& aim, bool steady) {
  const TypeDefinition type = input_.request.bands();
  const SearchOptions& search = options_.search;
  AimedArrival aimed;
  aimed.ego = egos_[random_.index(egos_.size())];
  const double heading = random_.uniform(type.min_heading, type.max_heading);
  const double contact_position = random_.uniform(-kMaxContactPosition, kMaxContactPosition);
  double sign = std::copysign(1.0, aim.touching.yaw);
  if (isOneBand(type)) sign = random_.uniform(-1.0, 1.0) > 0.0 ? 1.0 : -1.0;
  const BoxSize& ego_size = input_.snapshot.ego.size;
  const BoxSize& size = contender.track->size;
  aimed.offset = attackerOffset(ego_size, size, touchedSide({{}, ego_size}, {aim.touching, size}),
                                wrapAngle(sign * heading), contact_position, kContactDepth);
  aimed.contact = random_.uniform(earliest_, latest_);
  aimed.lead = std::max(0.0, random_.uniform(-search.max_lead, search.max_lead));
  const Pose2 target = compose(egoAt(aimed.ego, aimed.contact), aimed.offset);
  // Around the steady speed or, because the path may not be straight, any speed.
  Arrival& arrival = aimed.arrival;
  arrival.speed = steady || random_.uniform(-1.0, 1.0) > 0.0
                      ? steadySpeed(contender, target, aimed.contact) * random_.uniform(0.5, 1.5)
                      : random_.uniform(0.5, kMaxDrawnSpeed);
  arrival.start_acceleration = random_.bell(1.5);
  arrival.end_acceleration = random_.bell(1.5);
  settle(aimed);
  return aimed;
}

void ArrivalSampler::move(AimedArrival& aimed, double scale) {
  Pose2& offset = aimed.offset;
  offset.x += random_.bell(1.0 * scale);
  offset.y += random_.bell(0.6 * scale);
  offset.yaw = wrapAngle(offset.yaw + random_.bell(0.07 * scale));
  aimed.contact += random_.bell(0.2 * scale);
  aimed.lead += random_.bell(0.2 * scale);
  Arrival& arrival = aimed.arrival;
  arrival.speed += random_.bell((0.5 + 0.15 * arrival.speed) * scale);
  arrival.start_acceleration += random_.bell(1.0 * scale);
  arrival.end_acceleration += random_.bell(1.0 * scale);
  settle(aimed);
}

void ArrivalSampler::shift(AimedArrival& aimed, const Pose2& by) const {
  Pose2& offset = aimed.offset;
  offset = {offset.x + by.x, offset.y + by.y, wrapAngle(offset.yaw + by.yaw)};
  settle(aimed);
}

bool ArrivalSampler::canReach(const Contender& contender) const {
  const Motion& motion = contender.start.motion;
  const auto near_at = [&](double seconds) {
    const double speed = std::min(limits_.max_speed,
                                  motion.speed + 0.5 * limits_.max_forward_acceleration * seconds);
    return std::any_of(egos_.begin(), egos_.end(), [&](std::size_t ego) {
      const Vector2 position = egoAt(ego, seconds).position();
      return (position - motion.pose.position()).norm() < speed * seconds + kNear;
    });
  };
  return near_at(input_.request.tta) || near_at(latest_);
}

}  // namespace forge
