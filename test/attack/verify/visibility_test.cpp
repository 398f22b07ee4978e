#include "collision_forge/attack/verify/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// Returns the share of the way from `from` to `to` at which the line first crosses an edge of the
/// box; 2 if it crosses none.
double crossing(const Vector2& from, const Vector2& to, const OrientedBox& box) {
  const auto ring = corners(box);
  double first = 2.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2 edge = ring[(i + 1) % ring.size()] - ring[i];
    const Vector2 way = to - from;
    const Vector2 start = ring[i] - from;
    const double area = way.x() * edge.y() - way.y() * edge.x();
    if (std::abs(area) < 1e-12) continue;
    const double along = (start.x() * edge.y() - start.y() * edge.x()) / area;
    const double across = (start.x() * way.y() - start.y() * way.x()) / area;
    if (along >= 0.0 && across >= 0.0 && across <= 1.0) first = std::min(first, along);
  }
  return first;
}

/// The visible share by another method: rays at equal angles against the outlines of all boxes.
double shareByRays(const Vector2& from, const OrientedBox& target,
                   const std::vector<OrientedBox>& others) {
  constexpr int kRays = 20000;
  const double far = 200.0;
  int hits = 0;
  int seen = 0;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * M_PI * (i + 0.5) / kRays;
    const Vector2 to = from + far * Vector2(std::cos(angle), std::sin(angle));
    const double there = crossing(from, to, target);
    if (there > 1.0) continue;
    ++hits;
    const bool is_free = std::all_of(others.begin(), others.end(), [&](const OrientedBox& other) {
      return crossing(from, to, other) > there;
    });
    if (is_free) ++seen;
  }
  return static_cast<double>(seen) / hits;
}

TEST(Visibility, SharesAgreeWithRaysAgainstOutlines) {
  std::mt19937 draw(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(draw);
  };
  int partly = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<OrientedBox> boxes;
    while (boxes.size() < 6) {
      const OrientedBox box{{between(-15.0, 15.0), between(-15.0, 15.0), between(-3.0, 3.0)},
                            {between(0.5, 8.0), between(0.5, 2.5)}};
      const bool is_apart = std::none_of(boxes.begin(), boxes.end(),
                                         [&](const auto& other) { return overlaps(other, box); });
      if (is_apart && distanceToPoint(box, {0.0, 0.0}) > 1.0) boxes.push_back(box);
    }
    const OrientedBox target = boxes.back();
    boxes.pop_back();
    const double expected = shareByRays({0.0, 0.0}, target, boxes);
    std::vector<Block> blocks;
    for (const OrientedBox& box : boxes) blocks.push_back({box, 3.0});
    EXPECT_NEAR(viewOf({0.0, 0.0}, {target, 1.5}, blocks).visible, expected, 0.02) << trial;
    if (expected > 0.02 && expected < 0.98) ++partly;
  }
  EXPECT_GT(partly, 20) << "cases of which a part is in view";
}

TEST(Visibility, ABoxAroundTheObserverHidesNothing) {
  const BoxView view =
      viewOf({0.0, 0.0}, {{{10.0, 0.0, 0.0}, kCarSize}, 1.5}, {{{{0.5, 0.0, 0.0}, kCarSize}, 1.5}});
  EXPECT_EQ(view.visible, 1.0);
  EXPECT_FALSE(view.coverer);
}

/// A person 2 m behind a box of 1.8 m depth whose near side is 10 m away. By hand: the line from
/// the eye, 1.5 m above the ground, over the near edge (10 m) and over the far edge (11.8 m) of the
/// roof is 1.5 + (roof - 1.5) * 13.8 / edge m high at the person, 13.8 m away.
TEST(Visibility, AHeadAboveTheRoofIsSeen) {
  const auto isSeen = [](double roof, double height) {
    const Block person{{{14.1, 0.0, 0.0}, {0.6, 0.6}}, height};
    const Block car{{{10.9, 0.0, M_PI_2}, {4.5, 1.8}}, roof};
    return viewOf({0.0, 0.0}, person, {car}).visible > 0.5;
  };
  EXPECT_FALSE(isSeen(1.5, 1.15)) << "a child behind a car";
  EXPECT_FALSE(isSeen(1.5, 1.69)) << "1.69 - 1.50 m are less than a head";
  EXPECT_TRUE(isSeen(1.5, 1.71));
  EXPECT_TRUE(isSeen(1.5, 1.77)) << "an adult behind a car";
  EXPECT_FALSE(isSeen(2.0, 1.77)) << "an adult behind a van";
  EXPECT_FALSE(isSeen(1.7, 1.975)) << "over the near edge: 1.5 + 0.2 * 1.38 + 0.2 = 1.976 m";
  EXPECT_TRUE(isSeen(1.7, 1.977));
  EXPECT_FALSE(isSeen(0.9, 0.998)) << "over the far edge: 1.5 - 0.6 * 1.1695 + 0.2 = 0.998 m";
  EXPECT_TRUE(isSeen(0.9, 1.0));
}

/// An ego at 10 m/s along x and a walker that steps out from behind a parked car, contact after 4
/// s.
class SightTest : public testing::Test {
 protected:
  static constexpr double kContact = 4.0;

  SightTest() {
    future_.ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
    future_.agents = {futureTrack("parked", kCarSize, {38.0, -3.2, 0.0}, 0.0)};
    walker_ = straightDrive({42.3, -1.5 * kContact, M_PI_2}, 1.5, kContact);
    walker_.size = {0.7, 0.6};
  }

  /// Returns the first time of the last stretch in view, by rays every 10 ms.
  double seenByRays() const {
    double seen_from = kNow;
    for (int i = 0; i < 400; ++i) {
      const double time = kNow + 0.01 * i;
      std::vector<OrientedBox> boxes;
      for (const Track& agent : future_.agents) {
        boxes.push_back(boxAt(agent, stateAt(agent, time)->pose));
      }
      const Vector2 from = stateAt(future_.ego, time)->pose.position();
      const double share = shareByRays(from, {poseAt(walker_, time), walker_.size}, boxes);
      if (share < kSeenShare) seen_from = time + 0.01;
    }
    return seen_from;
  }

  Future future_;
  AttackerTrajectory walker_;
};

TEST_F(SightTest, ACarHidesAChildButNoAdultUnlessItIsHigh) {
  const auto hiderOf = [&](AgentClass agent_class) {
    walker_.agent_class = agent_class;
    return sightOf(walker_, future_, kNow + kContact).hidden_by_id;
  };
  EXPECT_EQ(hiderOf(AgentClass::kChild), "parked");
  EXPECT_EQ(hiderOf(AgentClass::kPedestrian), "");
  future_.agents.front().height = 1.9;
  EXPECT_EQ(hiderOf(AgentClass::kPedestrian), "parked");
  future_.agents.front().height = 0.7;
  EXPECT_EQ(hiderOf(AgentClass::kChild), "");
}

TEST_F(SightTest, BeginsWithinOneStepOfTheRays) {
  const Sight sight = sightOf(walker_, future_, kNow + kContact);
  EXPECT_EQ(sight.hidden_by_id, "parked");
  EXPECT_EQ(sight.hidden_by, Hider::kParkedVehicle);
  EXPECT_GT(sight.seen_from, kNow + 1.0);
  EXPECT_NEAR(sight.seen_from, seenByRays(), kSightStep);
}

TEST_F(SightTest, BeginsAtT0WithoutAHider) {
  future_.agents.clear();
  const Sight sight = sightOf(walker_, future_, kNow + kContact);
  EXPECT_EQ(sight.seen_from, kNow);
  EXPECT_EQ(sight.hidden_by_id, "");
}

TEST_F(SightTest, IgnoresTheAttackersOwnRecordedTrack) {
  future_.agents.front().id = walker_.attacker_id;
  EXPECT_EQ(sightOf(walker_, future_, kNow + kContact).hidden_by_id, "");
}

TEST_F(SightTest, ALeaderThatTurnsAsideReveals) {
  Track leader = futureTrack("leader", kCarSize, {15.0, 0.0, 0.0}, 10.0);
  for (AgentState& state : leader.states) {
    state.pose.y = -3.0 * std::max(0.0, state.time - kNow - 1.5);
  }
  future_.agents = {leader};
  walker_ = straightDrive({45.0, 0.0, 0.0}, 0.0, kContact);
  const Sight sight = sightOf(walker_, future_, kNow + kContact);
  EXPECT_EQ(sight.hidden_by, Hider::kLeader);
  EXPECT_NEAR(sight.seen_from, seenByRays(), kSightStep);
}

TEST_F(SightTest, APedestrianThatHidesHasNoKind) {
  future_.agents.front().agent_class = AgentClass::kPedestrian;
  const Sight sight = sightOf(walker_, future_, kNow + kContact);
  EXPECT_EQ(sight.hidden_by_id, "parked");
  EXPECT_FALSE(sight.hidden_by);
}

}  // namespace
}  // namespace forge
