#include "collision_forge/attack/search/parked_vehicle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr double kReach = 40.0;          // m from the contact within which places are tried
constexpr double kAlong = 0.5;           // m between places along a lane
constexpr double kAcross = 0.25;         // m between the points at which the kerb is searched
constexpr double kWidestLane = 8.0;      // m from the middle of a lane to the kerb beside it
constexpr double kKerbGap = 0.25;        // m between vehicle and kerb
constexpr double kEgoClearance = 0.5;    // m beside the ego; Euro NCAP's CPNCO has 1 m
constexpr double kBetween = 0.7;         // m between two parked vehicles
constexpr double kEgoStep = 0.1;         // s between the times at which the ego is tested
constexpr double kInLane = 1.2;          // m from the middle of a lane: stands in it
constexpr double kBesideJunction = 4.0;  // m from a path through a junction
constexpr double kLaneHeading = 0.6;     // rad
constexpr int kLongHidden = 10;          // steps of kSightStep beyond which longer is not better
constexpr std::size_t kMost = 2;         // parked vehicles

/// A place where a parked vehicle fits.
struct Place {
  OrientedBox box;
  const AddedKind* kind = nullptr;
  bool is_in_lane = false;
};

/// Returns true for cars and vans.
bool parks(const AddedKind& kind, const DriveLimitOptions& limits) {
  const BoxSize size{kind.length, kind.width};
  const VehicleClass kept = vehicleClassOf(kind.agent_class, size, limits);
  return kept == VehicleClass::kCar || kept == VehicleClass::kVan;
}

Block blockOf(const OrientedBox& box, const AddedKind& kind) {
  return {box, typicalHeight(kind.agent_class, box.size)};
}

class ParkingSearch {
 public:
  ParkingSearch(const HidingInput& input, const AttackOptions& options)
      : input_(input), options_(options), search_(input) {
    const Track& ego = input.future.ego;
    for (const AgentState& state : ego.states) ego_boxes_.push_back(boxAt(ego, state.pose));
    for (double time = input.past.now; time < input.contact; time += kEgoStep) {
      if (const auto state = stateAt(ego, time)) ego_boxes_.push_back(boxAt(ego, state->pose));
    }
  }

  std::vector<SupportVehicle> run(Status& refusal) {
    const std::vector<Place> places = fittingPlaces();
    std::vector<Place> chosen;
    const Place* best = nullptr;
    for (std::size_t count = 0; count < kMost; ++count) {
      const Place* added = bestOf(places, chosen, best);
      if (!added) break;
      chosen.push_back(*added);
      best = added;
    }
    if (chosen.empty()) refusal = refusalOf(places.size());
    std::vector<SupportVehicle> supports;
    for (const Place& place : chosen) {
      supports.push_back(
          {SupportRole::kParkedVehicle, standingVehicle(search_.newId("parked", supports.size()),
                                                        *place.kind, place.box.center, input_)});
    }
    return supports;
  }

 private:
  std::vector<Place> fittingPlaces() {
    std::vector<Place> places;
    const Vector2 contact = poseAt(input_.attacker, input_.contact).position();
    for (const std::size_t lane : input_.lanes.lanesWithin(contact, kReach)) {
      if (input_.lanes.map().lanes[lane].is_connector) continue;
      const Polyline& line = *input_.lanes.centerline(lane);
      for (double along = 0.0; along < line.length(); along += kAlong) {
        const Pose2 middle = line.poseAt(along);
        if ((middle.position() - contact).norm() > kReach) continue;
        addPlaces(middle, places);
      }
    }
    return places;
  }

  void addPlaces(const Pose2& middle, std::vector<Place>& places) {
    const double side = input_.lanes.map().driving_side == DrivingSide::kRight ? -1.0 : 1.0;
    const std::optional<double> kerb = kerbBeside(middle, side);
    if (!kerb) return;
    for (const AddedKind& kind : options_.added.kinds) {
      if (!parks(kind, options_.verification.drivable)) continue;
      const double across = *kerb - kKerbGap - 0.5 * kind.width;
      const OrientedBox box{compose(middle, {0.0, side * across, 0.0}), {kind.length, kind.width}};
      if (!search_.mayHide(blockOf(box, kind))) continue;
      if (const char* reason = whyNotAt(box)) {
        ++reasons_[reason];
        continue;
      }
      const bool is_in_lane = !input_.lanes.lanesNear(box.center, kInLane, kLaneHeading).empty();
      places.push_back({box, &kind, is_in_lane});
    }
  }

  std::optional<double> kerbBeside(const Pose2& middle, double side) const {
    for (double across = 0.0; across <= kWidestLane; across += kAcross) {
      const Vector2 point = compose(middle, {0.0, side * across, 0.0}).position();
      if (!input_.lanes.drivable().contains(point)) return across - kAcross;
    }
    return std::nullopt;
  }

  const char* whyNotAt(const OrientedBox& box) {
    if (!search_.isOnRoad(box)) return "stand on no road";
    const LaneMap& map = input_.lanes.map();
    for (const LaneMatch& match : input_.lanes.lanesNear(box.center, kBesideJunction, M_PI)) {
      if (map.lanes[match.lane].is_connector) return "stand in a junction";
    }
    if (isOnCrosswalk(box)) return "stand on a crosswalk";
    const OrientedBox wide = shrunk(box, -kEgoClearance);
    if (std::any_of(ego_boxes_.begin(), ego_boxes_.end(),
                    [&](const OrientedBox& ego) { return overlaps(ego, wide); })) {
      return "stand in the ego's way";
    }
    const RecordedTraffic& traffic = search_.traffic();
    for (int instant = traffic.firstInstant(); instant <= traffic.lastInstant(); ++instant) {
      if (traffic.touches(box.center, box.size, instant, kSupportClearance)) {
        has_room_ = true;
        return "stand in the way of another agent";
      }
    }
    return nullptr;
  }

  bool isOnCrosswalk(const OrientedBox& box) const {
    const auto places = samplePointsOf(box);
    const auto& features = input_.lanes.map().features;
    return std::any_of(features.begin(), features.end(), [&](const MapFeature& feature) {
      if (feature.kind != FeatureKind::kCrosswalk) return false;
      const Polygon outline{feature.points, {}};
      return std::any_of(places.begin(), places.end(),
                         [&](const Vector2& place) { return contains(outline, place); });
    });
  }

  Hiding hidingBy(const std::vector<Place>& parked) const {
    return search_.hidingBy([&](double, std::vector<Block>& blocks) {
      for (const Place& place : parked) blocks.push_back(blockOf(place.box, *place.kind));
    });
  }

  using Rank = std::tuple<bool, bool, int, double>;

  /// Returns the rank of a place, smallest first: beside the lanes, of a car, long hidden, seen
  /// late.
  static Rank rankOf(const Place& place, const Hiding& hiding) {
    return {place.is_in_lane, place.kind->agent_class != AgentClass::kCar,
            -std::min(hiding.hidden, kLongHidden), hiding.visible_for};
  }

  /// Returns the place that hides the attacker best together with the chosen ones; null if none
  /// hides it for longer than they do. A second vehicle is of the kind of the first one and stands
  /// as it does, in a lane or beside.
  const Place* bestOf(const std::vector<Place>& places, const std::vector<Place>& chosen,
                      const Place* before) const {
    const Place* best = nullptr;
    Rank rank{true, true, 1, 0.0};
    if (before) rank = rankOf(*before, hidingBy(chosen));
    for (const Place& place : places) {
      if (before && place.kind != before->kind) continue;
      const bool is_apart = std::all_of(chosen.begin(), chosen.end(), [&](const Place& other) {
        return !overlaps(shrunk(other.box, -kBetween), place.box);
      });
      if (!is_apart) continue;
      std::vector<Place> all = chosen;
      all.push_back(place);
      const Hiding hiding = hidingBy(all);
      if (!search_.isInRange(hiding) || !(rankOf(place, hiding) < rank)) continue;
      best = &place;
      rank = rankOf(place, hiding);
    }
    return best;
  }

  Status refusalOf(std::size_t fitting) const {
    if (fitting > 0) {
      return {StatusCode::kNoAttackWithinLimits,
              counted(fitting, "place") + " found, but none hides the attacker until visible_for"};
    }
    std::string text;
    for (const auto& [reason, count] : reasons_) {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + reason;
    }
    return {has_room_ ? StatusCode::kNoAttackWithinLimits : StatusCode::kRoadDoesNotAllow,
            text.empty() ? "no kerb is between the ego and the attacker" : text};
  }

  const HidingInput& input_;
  const AttackOptions& options_;
  HidingSearch search_;
  std::vector<OrientedBox> ego_boxes_;
  std::map<std::string, int> reasons_;
  bool has_room_ = false;  // a place is taken by other agents alone
};

}  // namespace

std::vector<SupportVehicle> findParkedVehicles(const HidingInput& input,
                                               const AttackOptions& options, Status& refusal) {
  return ParkingSearch(input, options).run(refusal);
}

}  // namespace forge
