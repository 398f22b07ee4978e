#include "collision_forge/attack/search/steering_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/verify/limits.h"

namespace forge {
namespace {

constexpr double kTolerance = 0.47;  // s

/// An ego that drives straight on, and an attacker that is to touch it at `tta`.
struct Case {
  AttackOptions options = shippedOptions();
  CollisionType type;
  double tta;
  Pose2 ego;
  double ego_speed;
  DriveStart start;

  Case(CollisionType wanted, double at, const Pose2& ego_now, double ego_moves,
       const Pose2& attacker, double speed)
      : type(wanted), tta(at), ego(ego_now), ego_speed(ego_moves) {
    start.motion.pose = attacker;
    start.motion.speed = speed;
    start.now = kNow;
    start.step = 0.1;
    start.points = static_cast<int>(std::floor((tta + kTolerance) / start.step)) + 1;
  }
  Pose2 egoAt(double seconds) const { return compose(ego, {ego_speed * seconds, 0.0, 0.0}); }
  SteeringAim aim() const {
    SteeringAim aim;
    aim.last_in_time = tta + kTolerance;
    aim.first_in_time = tta - kTolerance;
    const int steps = static_cast<int>(std::ceil(aim.last_in_time / SteeringSearch::kStep));
    for (int i = 0; i <= steps; ++i) aim.ego.push_back(egoAt(aim.last_in_time * i / steps));
    aim.ego_size = kEgoSize;
    aim.attacker_size = kCarSize;
    aim.band = shippedCrash().types.at(type);
    aim.depth = kContactDepth;
    return aim;
  }
  SteeringSearch search() const { return {start, aim(), options.verification.limits}; }
  /// The nearest knots of all rounds.
  std::vector<SteeringKnots> found(std::uint64_t seed = 0) const {
    Random random(seed);
    SteeringSearch steering = search();
    std::vector<SteeringKnots> nearest;
    for (int round = 0; round < options.search.steering_rounds; ++round)
      nearest = steering.next(random);
    return nearest;
  }
  std::vector<TrajectoryPoint> driven(const SteeringKnots& knots) const {
    std::vector<TrajectoryPoint> points;
    BicycleFamily(options.verification.limits).roll(start, knots, tta + kTolerance, points);
    return points;
  }
  /// Index of the first point that touches the ego; -1 without any.
  int firstTouch(const std::vector<TrajectoryPoint>& points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Pose2 there = egoAt(static_cast<double>(i) * start.step);
      if (overlaps({points[i].pose, kCarSize}, {there, kEgoSize})) return static_cast<int>(i);
    }
    return -1;
  }
  /// Touches on time at a heading of the type, and not before, for a bicycle within its limits.
  void expectHit(const SteeringKnots& knots) const {
    const auto points = driven(knots);
    const int touch = firstTouch(points);
    ASSERT_GE(touch, 0);
    EXPECT_NEAR(touch * start.step, tta, kTolerance + start.step);
    const Pose2& pose = points[static_cast<std::size_t>(touch)].pose;
    const double heading = std::abs(angleBetween(ego.yaw, pose.yaw));
    const TypeDefinition band = shippedCrash().types.at(type);
    EXPECT_GE(heading, band.min_heading - 0.1);
    EXPECT_LE(heading, band.max_heading + 0.1);
  }
};

TEST(SteeringSearch, FindsTheCrashThatLiesAhead) {
  const Case oncoming(CollisionType::kOppositeDirection, 3.0, {0.0, 0.0, 0.3}, 8.0,
                      compose({0.0, 0.0, 0.3}, {50.0, 3.0, M_PI}), 8.0);
  const auto found = oncoming.found();
  ASSERT_FALSE(found.empty());
  oncoming.expectHit(found.front());
}

TEST(SteeringSearch, FindsAUTurn) {
  const Case ahead(CollisionType::kOppositeDirection, 6.0, {10.0, -5.0, 2.0}, 4.0,
                   compose({10.0, -5.0, 2.0}, {20.0, 3.5, 0.0}), 5.0);
  const auto found = ahead.found();
  ASSERT_FALSE(found.empty());
  ahead.expectHit(found.front());
}

TEST(SteeringSearch, FindsNothingOutOfReach) {
  const Case far(CollisionType::kRearEnd, 2.0, {0.0, 0.0, 0.0}, 10.0, {-80.0, 0.0, 0.0}, 3.0);
  EXPECT_TRUE(far.found().empty());
  Random random(0);
  SteeringSearch search = far.search();
  search.next(random);
  // 100 m ahead by then, minus half of both cars and the distance driven at 5 m/s2 in 2.47 s.
  const double driven = 3.0 * 2.47 + 0.5 * 5.0 * 2.47 * 2.47;
  const double apart = 80.0 + 10.0 * 2.47 - 0.5 * (kEgoSize.length + kCarSize.length) - driven;
  EXPECT_GE(search.shortfall(), apart);
}

TEST(SteeringSearch, RoundsReduceTheShortfall) {
  const Case ahead(CollisionType::kOppositeDirection, 6.0, {0.0, 0.0, 0.0}, 4.0, {20.0, 3.5, 0.0},
                   5.0);
  Random random(3);
  SteeringSearch search = ahead.search();
  search.next(random);
  const double first = search.shortfall();
  for (int round = 1; round < 5; ++round) search.next(random);
  EXPECT_LT(search.shortfall(), 0.5 * first);
}

TEST(SteeringSearch, ReturnsTheNearestFirstUpToTheLimit) {
  Case oncoming(CollisionType::kOppositeDirection, 3.0, {0.0, 0.0, 0.0}, 8.0, {50.0, 3.0, M_PI},
                8.0);
  EXPECT_EQ(oncoming.found().size(), std::size_t{SteeringSearch::kConsidered});
}

}  // namespace
}  // namespace forge
