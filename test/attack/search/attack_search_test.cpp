#include "collision_forge/attack/search/attack_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/placement.h"
#include "collision_forge/attack/verify/limits.h"

namespace forge {
namespace {

/// A scene to search in. The ego drives at one of a few speeds.
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  Snapshot snapshot;
  Future future;
  std::vector<Track> egos;
  CollisionRequest request = requestFor();
  bool exact = false;

  Case(CollisionType type, double ego_speed, const Pose2& ego = {}) {
    request.type = type;
    snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, ego, ego_speed), {}, map);
    for (const double factor : {0.97, 0.99, 1.0, 1.01, 1.03}) {
      egos.push_back(futureTrack(kEgoId, kEgoSize, ego, factor * ego_speed));
    }
  }
  void add(const std::string& id, const Pose2& pose, double speed) {
    snapshot.agents.push_back(pastTrack(id, kCarSize, pose, speed));
    future.agents.push_back(futureTrack(id, kCarSize, pose, speed));
  }
  /// Where the ego, at its middle speed, is when the time is up.
  OrientedBox egoAtImpact() const {
    return {stateAt(egos[egos.size() / 2], kNow + request.tta)->pose, kEgoSize};
  }
  CollisionPattern pattern(const std::string& attacker, const Pose2& offset, double speed) const {
    return {request.type, attacker, kNow + request.tta, egoAtImpact(), offset, speed};
  }
  /// At the sides where the type's attackers stand.
  std::vector<CollisionPattern> patternsOf(const Track& agent) const {
    const double nominal = request.bands().nominal_heading;
    std::vector<CollisionPattern> patterns;
    for (const Placement& placement : placementsOf(request.type, map->driving_side)) {
      const double heading = wrapAngle(placement.sign < 0.0 ? -nominal : nominal);
      patterns.push_back(pattern(
          agent.id, attackerOffset(kEgoSize, kCarSize, placement.side, heading, 0.0, 0.0), 8.0));
      patterns.back().tolerance = options.prediction.pattern_tolerance;
    }
    return patterns;
  }
  std::vector<CollisionPattern> patterns() const {
    std::vector<CollisionPattern> patterns;
    for (const Track& agent : snapshot.agents) {
      for (CollisionPattern& pattern : patternsOf(agent)) patterns.push_back(std::move(pattern));
    }
    return patterns;
  }
  std::vector<FoundAttack> found(const std::vector<CollisionPattern>& patterns) const {
    std::vector<const Track*> pointers;
    for (const Track& ego : egos) pointers.push_back(&ego);
    return searchAttacks({snapshot, future, pointers, patterns, request, LaneIndex(map), exact},
                         options);
  }
  std::vector<FoundAttack> found() const { return found(patterns()); }
};

Case rearEnd() {
  Case scene(CollisionType::kRearEnd, 10.0);
  scene.add("behind", {-20.0, 0.3, 0.0}, 12.0);
  return scene;
}

Case oncoming() {
  Case scene(CollisionType::kOppositeDirection, 10.0);
  scene.add("oncoming", {80.0, 3.5, M_PI}, 10.0);
  return scene;
}

Case crossing() {
  Case scene(CollisionType::kJunctionCrossing, 10.0, {-40.0, -1.75, 0.0});
  scene.map = fourWayJunction();
  scene.add("crossing", {1.75, -35.0, M_PI_2}, 8.0);
  return scene;
}

Case laneChange() {
  Case scene(CollisionType::kLaneChange, 10.0);
  scene.add("beside", {-6.0, 3.5, 0.0}, 11.0);
  return scene;
}

Case leftTurn() {
  Case scene(CollisionType::kLtap, 8.0, {-32.0, -1.75, 0.0});
  scene.map = fourWayJunction();
  scene.add("turning", {32.0, 1.75, M_PI}, 8.0);
  return scene;
}

std::vector<Case> allCases() {
  return {rearEnd(), oncoming(), crossing(), laneChange(), leftTurn()};
}

TEST(SearchAttacks, FindsAnObviousAttackOfEveryType) {
  for (const Case& scene : allCases()) {
    const auto attacks = scene.found();
    ASSERT_FALSE(attacks.empty()) << toString(scene.request.type);
    EXPECT_GE(attacks[0].score.share, 0.8) << toString(scene.request.type);
    EXPECT_EQ(attacks[0].attacker, &scene.snapshot.agents[0]);
  }
}

TEST(SearchAttacks, ComeBestFirstWithTheScoresOfTheirMotions) {
  for (const Case& scene : allCases()) {
    std::vector<const Track*> egos;
    for (const Track& ego : scene.egos) egos.push_back(&ego);
    const FutureScorer scorer(egos, scene.future.agents, scene.request, kNow,
                              scene.map->driving_side, scene.options);
    const auto patterns = scene.patterns();
    const auto attacks = scene.found(patterns);
    EXPECT_LE(attacks.size(), 2 * static_cast<std::size_t>(scene.options.search.kept))
        << "of each family";
    for (std::size_t i = 0; i < attacks.size(); ++i) {
      const FutureScore score = scorer.score(*attacks[i].attacker, attacks[i].points, 2);
      EXPECT_EQ(attacks[i].score.share, score.share);
      EXPECT_NEAR(attacks[i].score.closeness, score.closeness, 1e-9);
      EXPECT_GT(attacks[i].score.share, 0.0);
      EXPECT_EQ(attacks[i].hits.size(), std::lround(score.share * 5.0));
      EXPECT_EQ(attacks[i].miss.distance,
                (score.contact.position() - attacks[i].aim->attacker_offset.position()).norm());
      if (i > 0) {
        EXPECT_LE(attacks[i].objective, attacks[i - 1].objective);
      }
    }
  }
}

/// The ego ahead in a bend of 25 m radius to the left, on a road 5 m wide; the attacker behind.
Case bendAhead() {
  constexpr double kRadius = 25.0;
  const auto on_bend = [](double s, double lateral) {
    const double angle = s / kRadius;
    const double radius = kRadius - lateral;
    return Pose2{radius * std::sin(angle), kRadius - radius * std::cos(angle), angle};
  };
  Case scene(CollisionType::kRearEnd, 0.0, on_bend(38.0, 0.0));
  scene.map = emptyMap();
  Lane lane;
  lane.id = "bend";
  for (int x = -50; x < 0; ++x) lane.centerline.push_back({static_cast<double>(x), 0.0, 0.0});
  for (int s = 0; s < 75; ++s) lane.centerline.push_back(on_bend(s, 0.0));
  scene.map->lanes = {lane};
  scene.map->drivable_area = {rectangle(-50.0, -2.5, 0.5, 2.5)};
  std::vector<Vector2> outer;
  std::vector<Vector2> ring;
  for (int s = 0; s < 75; ++s) {
    ring.push_back(on_bend(s, -2.5).position());
    outer.push_back(on_bend(s, 2.5).position());
  }
  ring.insert(ring.end(), outer.rbegin(), outer.rend());
  scene.map->drivable_area.push_back({ring, {}});
  scene.add("behind", {-8.0, 0.0, 0.0}, 10.0);
  return scene;
}

TEST(SearchAttacks, PreferAFollowerOfTheLaneToOneOffTheRoad) {
  double careful = 0.0;
  double careless = 0.0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Case scene = bendAhead();
    scene.request.seed = seed;
    const auto attacks = scene.found();
    ASSERT_FALSE(attacks.empty());
    EXPECT_EQ(attacks[0].score.share, 1.0);
    EXPECT_LE(attacks[0].off_road, scene.options.search.good_off_road);
    careful += attacks[0].off_road;
    scene.options.search.off_road_weight = 0.0;
    scene.options.search.good_off_road = 1.0;
    careless += scene.found().at(0).off_road;
  }
  EXPECT_LT(careful, 0.5 * careless);
}

TEST(SearchAttacks, NeverCrossAKerb) {
  Case scene = rearEnd();
  scene.map->drivable_area.clear();
  scene.map->walkways = {rectangle(-13.0, -60.0, -11.0, 60.0)};
  EXPECT_TRUE(scene.found().empty()) << "a walkway between attacker and ego";
  scene.map->drivable_area = {rectangle(-200.0, -5.0, 200.0, 5.0)};
  EXPECT_FALSE(scene.found().empty()) << "a road leads across it";
  scene.map->drivable_area.clear();
  scene.map->walkways = {rectangle(-25.0, -3.0, -15.0, 3.0)};
  EXPECT_FALSE(scene.found().empty()) << "who is on a walkway may leave it";
  scene.map->walkways.clear();
  EXPECT_FALSE(scene.found().empty());
}

TEST(SearchAttacks, FindNothingOutOfReach) {
  Case far(CollisionType::kRearEnd, 10.0);
  far.add("behind", {-150.0, 0.0, 0.0}, 10.0);
  EXPECT_TRUE(far.found().empty());
  Case soon = crossing();
  soon.request.tta = 0.5;
  EXPECT_TRUE(soon.found().empty());
}

TEST(SearchAttacks, TheBicycleFindsAttacksThatNoQuinticCan) {
  // From rest, heading away from where it has to go.
  Case scene(CollisionType::kJunctionCrossing, 6.0, {-24.0, 0.0, 0.0});
  scene.map = emptyMap();
  scene.add("waiting", {-14.0, -11.0, -1.0}, 0.0);
  const auto share = [](const std::vector<FoundAttack>& attacks) {
    return attacks.empty() ? 0.0 : attacks[0].score.share;
  };
  const double with_bicycle = share(scene.found());
  scene.options.search.bicycle_targets = 0;
  scene.options.search.bicycle_rounds = 0;
  scene.options.search.steering_rounds = 0;
  EXPECT_EQ(share(scene.found()), 0.0);
  EXPECT_EQ(with_bicycle, 1.0);
}

/// A car that overtakes on the right half of the left lane, in a scene without uncertainty.
Case overtaken() {
  Case scene(CollisionType::kLaneChange, 8.0);
  scene.add("beside", {-16.0, 3.5, 0.0}, 10.0);
  scene.egos = {futureTrack(kEgoId, kEgoSize, {}, 8.0)};
  return scene;
}

/// The attacker's front right corner at the ego's left rear corner.
Pose2 atLeftRearCorner(double heading) {
  const Vector2 corner(0.5 * kCarSize.length, -0.5 * kCarSize.width);
  const Pose2 turned = compose({0.0, 0.0, heading}, {corner.x(), corner.y(), 0.0});
  return {-0.5 * kEgoSize.length - turned.x + 0.2, 0.5 * kEgoSize.width - turned.y, heading};
}

TEST(SearchAttacks, ReachARequestedPatternThatIsNoPlacementOfTheType) {
  Case scene = overtaken();
  scene.request.seed = 3;
  for (const double heading : {-0.2, -0.26, -0.35}) {
    const auto attacks = scene.found({scene.pattern("beside", atLeftRearCorner(heading), 11.0)});
    ASSERT_FALSE(attacks.empty()) << heading;
    EXPECT_LT(attacks[0].miss.distance, 0.3) << heading;
    EXPECT_LT(attacks[0].miss.heading, 0.05) << heading;
  }
}

TEST(SearchAttacks, PreferTheFutureNearestToThePatternsEgo) {
  Case scene = rearEnd();
  for (std::size_t i = 0; i < scene.egos.size(); ++i) {
    std::vector<CollisionPattern> patterns = scene.patternsOf(scene.snapshot.agents[0]);
    for (CollisionPattern& pattern : patterns) {
      pattern.ego.center = stateAt(scene.egos[i], pattern.time)->pose;
    }
    const auto attacks = scene.found(patterns);
    ASSERT_FALSE(attacks.empty());
    EXPECT_EQ(attacks[0].score.share, 1.0);
    EXPECT_EQ(attacks[0].hits[0], &scene.egos[i]);
  }
}

TEST(SearchAttacks, ExactModePenalisesAMissMost) {
  Case scene = overtaken();
  scene.exact = true;
  const auto attacks = scene.found({scene.pattern("beside", atLeftRearCorner(-0.3), 11.0)});
  ASSERT_FALSE(attacks.empty());
  EXPECT_TRUE(isExact(attacks[0].miss));
}

}  // namespace
}  // namespace forge
