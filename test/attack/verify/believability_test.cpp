#include "collision_forge/attack/verify/believability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kDegree = M_PI / 180.0;

const BelievabilityOptions kOptions = shippedBelievability();

RoadUse useOf(const std::shared_ptr<LaneMap>& map, const Pose2& start, double speed = 5.0,
              double until = kNow + 2.0) {
  return roadUse(straightDrive(start, speed, 2.0).points, kCarSize, until, LaneIndex(map),
                 kOptions);
}

/// Two carriageways of 7 m along x with 4 m of grass between them, from y = -2 to 2, and a walkway
/// of 2 m at the southern edge.
std::shared_ptr<LaneMap> dividedRoad() {
  auto map = emptyMap();
  map->lanes = {straightLane("east", {-200.0, -5.5}, {200.0, -5.5}),
                straightLane("west", {200.0, 5.5}, {-200.0, 5.5})};
  map->drivable_area = {rectangle(-200.0, -9.0, 200.0, -2.0), rectangle(-200.0, 2.0, 200.0, 9.0)};
  map->walkways = {rectangle(-200.0, -11.0, 200.0, -8.0)};
  return map;
}

TEST(RoadUse, AVehicleInItsLaneIsOnALane) {
  const RoadUse use = useOf(dividedRoad(), {0.0, -5.5, 0.0});
  EXPECT_EQ(use.on_lane, 1.0);
  EXPECT_EQ(use.wrong_way, 0.0);
  EXPECT_EQ(use.off_road, 0.0);
  EXPECT_EQ(use.on_walkway, 0.0);
  EXPECT_EQ(use.on_island, 0.0);
}

TEST(RoadUse, WrongWayIsAgainstTheLaneWithNoneAlong) {
  const RoadUse use = useOf(dividedRoad(), {0.0, -5.5, M_PI});
  EXPECT_EQ(use.on_lane, 0.0);
  EXPECT_EQ(use.wrong_way, 1.0);
  EXPECT_EQ(useOf(twoLaneRoad(), {0.0, 1.75, M_PI}).wrong_way, 0.0) << "both lanes are near";
}

TEST(RoadUse, EndsAtTheFirstPointAtOrAfterTheEnd) {
  EXPECT_NEAR(useOf(twoLaneRoad(), {194.9, 0.0, 0.0}, 5.0, kNow + 1.55).on_lane, 15.0 / 17.0, 1e-9);
  EXPECT_EQ(useOf(twoLaneRoad(), {201.9, 0.0, 0.0}, 5.0, kNow).on_lane, 1.0);
}

/// Stands beside the eastbound lane of a road, moves off 3 s before a contact 4 s from now.
std::vector<TrajectoryPoint> pulledOut(double across) {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 40; ++i) {
    const double moving = std::max(0.0, 0.1 * i - 1.0);
    points.push_back({kNow + 0.1 * i, {moving * moving, across, 0.0}, 2.0 * moving, 0.0, 0.0});
  }
  return points;
}

TEST(RoadUse, ForAPullOutBeginsWithTheManoeuvre) {
  const LaneIndex lanes(twoLaneRoad());
  const auto useUntilManoeuvre = [&](const std::vector<TrajectoryPoint>& points, double contact) {
    return roadUseOfAttack(points, kCarSize, kNow + contact, lanes, kOptions);
  };
  EXPECT_EQ(useUntilManoeuvre(pulledOut(-3.0), 4.0).on_lane, 1.0) << "who is parked is on no lane";
  // It drives beside the lane for longer than a manoeuvre lasts.
  EXPECT_EQ(useUntilManoeuvre(pulledOut(-3.0), 5.5).on_lane, 0.0);
  EXPECT_EQ(useUntilManoeuvre(pulledOut(0.0), 5.5).on_lane, 1.0);
  const std::vector<TrajectoryPoint> driven = straightDrive({0.0, -3.0, 0.0}, 5.0, 4.0).points;
  EXPECT_EQ(useUntilManoeuvre(driven, 4.0).on_lane, 0.0) << "who drives is not parked";
}

TEST(RoadUse, AChangeBetweenNeighbouringLanesIsOnALane) {
  auto map = emptyMap();
  map->lanes = {straightLane("right", {-200.0, 0.0}, {200.0, 0.0}),
                straightLane("left", {-200.0, 3.5}, {200.0, 3.5})};
  EXPECT_EQ(useOf(map, {0.0, 0.0, 20.0 * kDegree}).on_lane, 1.0) << "3.4 m to the left in all";
  EXPECT_LT(useOf(map, {0.0, 0.0, 30.0 * kDegree}).on_lane, 0.1) << "too steep";
}

TEST(RoadUse, OffRoadIsTheMeanShareOfTheBox) {
  // One row of three of the box's places, at -8.6 - 0.76 m, is beyond the edge at -9 m.
  EXPECT_NEAR(useOf(dividedRoad(), {0.0, -8.6, 0.0}).off_road, 1.0 / 3.0, 1e-9);
  EXPECT_EQ(useOf(dividedRoad(), {0.0, 50.0, 0.0}).off_road, 1.0);
  EXPECT_EQ(useOf(emptyMap(), {0.0, 50.0, 0.0}).off_road, 0.0) << "nobody knows";
}

TEST(RoadUse, AWalkwayUnderADrivableAreaIsRoad) {
  EXPECT_EQ(useOf(dividedRoad(), {0.0, -8.0, 0.0}).on_walkway, 0.0);
  EXPECT_EQ(useOf(dividedRoad(), {0.0, -8.6, 0.0}).on_walkway, 1.0);
  EXPECT_EQ(useOf(dividedRoad(), {0.0, -8.6, 0.0}).on_island, 0.0);
}

TEST(RoadUse, AMedianIsAnIsland) {
  const RoadUse use = useOf(dividedRoad(), {0.0, 0.0, 0.0});
  EXPECT_EQ(use.on_island, 1.0);
  EXPECT_NEAR(use.off_road, 1.0, 1e-9);
  EXPECT_EQ(use.on_walkway, 0.0);
  EXPECT_EQ(useOf(dividedRoad(), {0.0, 0.0, M_PI_2}, 0.0).on_island, 1.0) << "whichever way";
  EXPECT_EQ(useOf(dividedRoad(), {0.0, 20.0, 0.0}).on_island, 0.0) << "road on one side only";
}

TEST(StaysOnRoad, ForAVehicleThatCanStopOrTurnBeforeTheEdge) {
  const LaneIndex lanes(dividedRoad());
  const auto stays = [&](double heading, double speed) {
    return staysOnRoad({kNow, {0.0, -5.5, heading}, speed, 0.0, 0.0}, kCarSize, lanes);
  };
  EXPECT_TRUE(stays(0.0, 30.0)) << "along the road";
  EXPECT_TRUE(stays(-10.0 * kDegree, 15.0)) << "turns back within 0.85 m to the side";
  EXPECT_TRUE(stays(-M_PI_2, 3.0)) << "stops within 1.1 m, 0.4 m before the edge";
  EXPECT_FALSE(stays(-M_PI_2, 8.0)) << "heads for the edge as from the stem of a T junction";
  EXPECT_FALSE(stays(M_PI_2, -8.0)) << "the same in reverse";
}

TEST(StaysOnRoad, NobodyLeavesARoadThatIsUnknown) {
  EXPECT_TRUE(
      staysOnRoad({kNow, {0.0, 50.0, 0.0}, 20.0, 0.0, 0.0}, kCarSize, LaneIndex(emptyMap())));
}

TEST(OnIsland, AWideFieldIsNoIsland) {
  const LaneIndex lanes(dividedRoad());
  EXPECT_TRUE(isOnIsland({0.0, 0.0, 0.3}, lanes, 3.0));
  EXPECT_FALSE(isOnIsland({0.0, 0.0, 0.3}, lanes, 1.0)) << "the road is 2 m away";
}

/// Names of the lanes that fit a type at an ego's pose.
std::vector<std::string> fitting(const std::shared_ptr<LaneMap>& map, CollisionType type,
                                 const Pose2& ego, Turning turning = Turning::kAttacker) {
  const LaneIndex lanes(map);
  CollisionRequest request = believableRequestFor(type);
  request.turning = turning;
  std::vector<std::string> names;
  for (const FittingLane& lane : fittingLanes({ego, kEgoSize}, request, lanes, kOptions)) {
    names.push_back(map->lanes[lane.lane].id);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(FittingLanes, OnAStraightRoadAreTheEgosAndTheOncomingLane) {
  const Pose2 ego{0.0, 0.0, 0.0};
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kRearEnd, ego), Names{"east"});
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kLaneChange, ego), Names{"east"});
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kOppositeDirection, ego), Names{"west"});
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kJunctionCrossing, ego), Names{});
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kLtap, ego), Names{});
}

TEST(FittingLanes, ForLtapLeadToTheEgosRightInRightHandTraffic) {
  const Pose2 ego{0.0, -1.75, 0.0};
  auto map = fourWayJunction();
  EXPECT_EQ(fitting(map, CollisionType::kLtap, ego), Names{"south"});
  map->driving_side = DrivingSide::kLeft;
  EXPECT_EQ(fitting(map, CollisionType::kLtap, ego), Names{"north"});
}

TEST(FittingLanes, ForATurningEgoAreOncomingLanes) {
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kLtap, {0.0, 3.5, 0.8}, Turning::kEgo),
            Names{"west"})
      << "the ego has turned left by 46 degrees";
  EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kLtap, {0.0, 3.5, -0.8}, Turning::kEgo), Names{});
}

TEST(PassesJunction, OnlyBetweenTheTimesAndOnJunctionLanes) {
  auto map = twoLaneRoad();
  const Track ego = futureTrack(kEgoId, kEgoSize, {0.0, 0.0, 0.0}, 10.0);
  EXPECT_TRUE(passesJunction(ego, kNow, kNow + 4.0, LaneIndex(map), kOptions)) << "none is marked";
  map->lanes.push_back(straightLane("through", {20.0, 0.5}, {30.0, 0.5}));
  map->lanes.back().is_intersection = true;
  EXPECT_FALSE(passesJunction(ego, kNow, kNow + 4.0, LaneIndex(map), kOptions))
      << "the lane of the road is nearer";
  map->lanes[0].centerline = straightLane("east", {-200.0, 0.0}, {19.0, 0.0}).centerline;
  EXPECT_TRUE(passesJunction(ego, kNow, kNow + 4.0, LaneIndex(map), kOptions));
  EXPECT_FALSE(passesJunction(ego, kNow, kNow + 1.0, LaneIndex(map), kOptions)) << "not yet there";
}

TEST(RoadAllows, AnEgoThatTurnsOnlyIfItDoes) {
  CollisionRequest request = believableRequestFor(CollisionType::kLtap, 2.0);
  request.turning = Turning::kEgo;
  const LaneIndex lanes(twoLaneRoad());
  Track ego = futureTrack(kEgoId, kEgoSize, {0.0, 3.5, 0.8}, 0.0);
  EXPECT_FALSE(roadAllows(ego, kNow, request, lanes, kOptions)) << "it stands at 46 degrees";
  ego.states.front().pose.yaw = 0.0;
  EXPECT_TRUE(roadAllows(ego, kNow, request, lanes, kOptions));
}

TEST(RoadAllows, AnyTypeIfOneOfThemIsPossible) {
  const LaneIndex lanes(twoLaneRoad());
  const CollisionRequest request = believableRequestFor(CollisionType::kAny, 2.0);
  EXPECT_TRUE(roadAllows(futureTrack(kEgoId, kEgoSize, {}, 5.0), kNow, request, lanes, kOptions));
  const Track far = futureTrack(kEgoId, kEgoSize, {0.0, 500.0, 0.0}, 5.0);
  EXPECT_FALSE(roadAllows(far, kNow, request, lanes, kOptions));
}

TEST(FittingLanes, AllowAHeadingSlackBeyondTheBand) {
  const double slack = kOptions.road_heading;
  const double band = shippedCrash().types.at(CollisionType::kRearEnd).max_heading;
  const Pose2 ego{0.0, 0.0, 0.0};
  for (const double off : {-0.01, 0.01}) {
    const double yaw = band + slack + off;
    auto map = emptyMap();
    map->lanes = {straightLane("askew", {0.0, 0.0}, {50.0 * std::cos(yaw), 50.0 * std::sin(yaw)})};
    EXPECT_EQ(fitting(map, CollisionType::kRearEnd, ego).size(), off < 0.0 ? 1U : 0U);
  }
}

TEST(FittingLanes, MustPassNearTheBox) {
  const double edge = 0.5 * kEgoSize.width + kOptions.road_distance;
  for (const double off : {-0.01, 0.01}) {
    EXPECT_EQ(fitting(twoLaneRoad(), CollisionType::kRearEnd, {0.0, -edge - off, 0.0}).size(),
              off < 0.0 ? 1U : 0U);
  }
}

TEST(FittingLanes, AgreeWithABruteForceSearch) {
  const LaneIndex lanes(fourWayJunction());
  for (int i = 0; i < 500; ++i) {
    const OrientedBox ego{{0.1 * (i % 37) - 2.0, 0.2 * (i % 41) - 4.0, 0.1 * i}, kEgoSize};
    for (const CollisionType type :
         {CollisionType::kRearEnd, CollisionType::kLaneChange, CollisionType::kJunctionCrossing}) {
      const TypeDefinition band = shippedCrash().types.at(type);
      std::vector<double> nearest(lanes.map().lanes.size(), 1e9);
      for (const LaneSample& sample : lanes.grid().samplesNear({0.0, 0.0}, 1e9)) {
        const double turn = std::abs(
            wrapAngle(std::atan2(sample.heading.y(), sample.heading.x()) - ego.center.yaw));
        if (turn < band.min_heading - kOptions.road_heading) continue;
        if (turn > band.max_heading + kOptions.road_heading) continue;
        const OrientedBox point{{sample.position.x(), sample.position.y(), 0.0}, {}};
        nearest[sample.lane] = std::min(nearest[sample.lane], distance(ego, point));
      }
      const auto found = fittingLanes(ego, believableRequestFor(type), lanes, kOptions);
      EXPECT_EQ(static_cast<std::ptrdiff_t>(found.size()),
                std::count_if(nearest.begin(), nearest.end(),
                              [](double distance) { return distance <= kOptions.road_distance; }));
      for (const FittingLane& lane : found) {
        const OrientedBox point{lane.pose, {}};
        EXPECT_NEAR(distance(ego, point), nearest[lane.lane], 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace forge
