#include "collision_forge/attack/search/conduct.h"

#include <algorithm>

#include "collision_forge/attack/search/walker_path.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/reversing.h"
#include "collision_forge/attack/verify/step_out.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

// s before the contact at which a standing vehicle starts, chosen on recorded scenes
// (docs/results.md).
constexpr double kStarts[] = {1.6, 2.3, 3.2};
// Cost per second off the lane before before_contact of config/believability.yaml.
constexpr double kDepartureWeight = 0.2;
// m/s and m/s2 from rest of drivers who reverse into a road: fast, usual, slow. Own choice.
constexpr double kBackingSpeeds[] = {2.4, 1.6, 1.0};
constexpr double kBackingAcceleration = 1.0;

class DrivingConduct : public Conduct {
 public:
  DrivingConduct(const SearchInput& input, const BelievabilityOptions& options)
      : is_believable_(!input.request.crash.believable),
        lanes_(drivenLanes(input.request, input.lanes)),
        options_(options) {}

  std::vector<double> startsBefore(double) const override {
    return {std::begin(kStarts), std::end(kStarts)};
  }
  RoadVerdict judge(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                    double contact) const override {
    const RoadUse road = roadUseOfAttack(points, size, contact, lanes_, options_);
    return {road, is_believable_ ||
                      implausibilityOf(road, points, size, contact, lanes_, options_).empty()};
  }
  double departureCost(double departure) const override {
    return kDepartureWeight * std::max(0.0, departure - options_.before_contact);
  }

 private:
  bool is_believable_;  // whatever the motion
  const LaneIndex& lanes_;
  const BelievabilityOptions& options_;
};

class WalkingConduct : public Conduct {
 public:
  WalkingConduct(AgentClass agent_class, const SearchInput& input)
      : gait_(gaitOf(agent_class)),
        is_believable_(!input.request.crash.believable),
        lanes_(input.lanes) {}

  std::vector<double> startsBefore(double distance) const override {
    std::vector<double> starts;
    for (const double speed : gait_.speeds) {
      starts.push_back(std::max(0.0, distance) / speed + 0.5 * speed / gait_.acceleration);
    }
    return starts;
  }
  RoadVerdict judge(const std::vector<TrajectoryPoint>& points, const BoxSize&,
                    double contact) const override {
    RoadVerdict verdict;
    verdict.road.on_lane = 1.0;  // lanes are not for pedestrians
    verdict.is_believable =
        is_believable_ || implausibleWalk(stepOutOf(points, contact, lanes_)).empty();
    return verdict;
  }
  double departureCost(double) const override { return 0.0; }

 private:
  Gait gait_;
  bool is_believable_;  // whatever the motion
  const LaneIndex& lanes_;
};

/// A vehicle that reverses out of a bay or a drive.
class BackingConduct : public Conduct {
 public:
  BackingConduct(const SearchInput& input, const BelievabilityOptions& options)
      : lanes_(input.lanes), options_(options) {}

  std::vector<double> startsBefore(double distance) const override {
    std::vector<double> starts;
    for (const double speed : kBackingSpeeds) {
      starts.push_back(std::max(0.0, distance) / speed + 0.5 * speed / kBackingAcceleration);
    }
    return starts;
  }
  RoadVerdict judge(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                    double contact) const override {
    RoadVerdict verdict;
    verdict.road.on_lane = 1.0;  // it crosses lanes
    verdict.is_believable = implausibleReversing(points, size, contact, lanes_, options_).empty();
    return verdict;
  }
  double departureCost(double) const override { return 0.0; }

 private:
  const LaneIndex& lanes_;
  const BelievabilityOptions& options_;
};

}  // namespace

std::unique_ptr<const Conduct> conductOf(AgentClass agent_class, const SearchInput& input,
                                         const VerificationOptions& options) {
  if (isOnFoot(agent_class)) return std::make_unique<WalkingConduct>(agent_class, input);
  if (input.request.reverses()) {
    return std::make_unique<BackingConduct>(input, options.believability);
  }
  return std::make_unique<DrivingConduct>(input, options.believability);
}

}  // namespace forge
