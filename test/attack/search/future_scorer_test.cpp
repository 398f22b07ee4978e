#include "collision_forge/attack/search/future_scorer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

const double kAlong = 0.5 * (kEgoSize.length + kCarSize.length);  // m between middles, end to end
constexpr double kTta = 4.0;                                      // s

/// The attacker drives along +x from the origin at 15 m/s; the egos are in its way.
struct Case {
  AttackOptions options = shippedOptions();
  std::vector<Track> egos;
  std::vector<Track> agents;
  CollisionRequest request = requestFor();
  DrivingSide driving_side = DrivingSide::kRight;
  Track attacker = pastTrack("attacker", kCarSize, {}, 15.0);
  std::vector<TrajectoryPoint> points = straightDrive({}, 15.0, 8.0).points;

  Case() { request.tta = kTta; }

  FutureScorer scorer() const {
    std::vector<const Track*> pointers;
    for (const Track& ego : egos) pointers.push_back(&ego);
    return {pointers, agents, request, kNow, driving_side, options};
  }
  FutureScore score() const { return scorer().score(attacker, points); }
  std::vector<std::size_t> hits() const { return scorer().hits(attacker, points); }
  void addEgo(const Pose2& pose, double speed) {
    egos.push_back(futureTrack(kEgoId, kEgoSize, pose, speed));
  }
  void addStanding(const Pose2& pose) {
    agents.push_back(futureTrack("other" + std::to_string(agents.size()), kCarSize, pose, 0.0));
  }
};

/// Egos at 10 m/s, ahead by what is closed at these times.
Case rearEnds(const std::vector<double>& times) {
  Case scene;
  for (const double time : times) {
    scene.addEgo({kAlong + 5.0 * time, 0.0, 0.0}, 10.0);
  }
  return scene;
}

TEST(FutureScorer, ShareIsTheShareOfFuturesHit) {
  const Case scene = rearEnds({4.0, 2.0, 4.1, 7.0, 3.9, 9.0, 1.0, 8.0});
  EXPECT_EQ(scene.score().share, 3.0 / 8.0);
  EXPECT_EQ(scene.hits(), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(scene.scorer().hits(scene.attacker, scene.points, 2),
            (std::vector<std::size_t>{2, 4, 0}));
  EXPECT_EQ(rearEnds({4.0}).score().share, 1.0);
  EXPECT_EQ(rearEnds({9.0}).score().share, 0.0);
}

TEST(FutureScorer, ReturnsTheContactInThePreferredOrTheMiddleHit) {
  // Egos that meet the attacker off their middles, each at another place.
  Case scene = rearEnds({4.0, 2.0, 4.0, 4.0});
  for (std::size_t i = 0; i < scene.egos.size(); ++i) {
    for (AgentState& state : scene.egos[i].states) state.pose.y = 0.1 * static_cast<double>(i);
  }
  const auto score = [&](std::size_t preferred) {
    return scene.scorer().score(scene.attacker, scene.points, preferred);
  };
  for (const std::size_t preferred : {0U, 2U, 3U}) {
    EXPECT_EQ(score(preferred).met, preferred);
    EXPECT_NEAR(score(preferred).contact.y, -0.1 * static_cast<double>(preferred), 1e-5);
    EXPECT_NEAR(score(preferred).contact.x, -kAlong, 1e-4);
    EXPECT_NEAR(score(preferred).contact.yaw, 0.0, 1e-5);
  }
  EXPECT_EQ(score(1).met, 2U) << "of 0, 2 and 3";
}

TEST(FutureScorer, HeadingsKeepAMarginToTheBand) {
  const TypeDefinition band = shippedCrash().types.at(CollisionType::kRearEnd);
  const double narrowed = band.max_heading - kHeadingMargin;
  for (const double sign : {1.0, -1.0}) {
    Case scene;
    for (const double yaw : {narrowed - 0.002, narrowed + 0.002}) {
      scene.egos.push_back(rearEnds({4.0}).egos[0]);
      for (AgentState& state : scene.egos.back().states) state.pose.yaw = sign * yaw;
    }
    EXPECT_EQ(scene.hits(), (std::vector<std::size_t>{0}));
  }
}

TEST(FutureScorer, BandsThatEndAtZeroOrPiHaveNoMarginThere) {
  EXPECT_EQ(rearEnds({4.0}).score().share, 1.0) << "heading 0 in a band from 0";
  Case oncoming;
  oncoming.request.type = CollisionType::kOppositeDirection;
  oncoming.addEgo({25.0 * 4.0 + kAlong, 0.0, M_PI}, 10.0);
  EXPECT_EQ(oncoming.score().share, 1.0);
}

TEST(FutureScorer, OtherAgentsCountOnlyInFuturesThatTouchThemFirst) {
  Case scene = rearEnds({3.7, 4.3});
  scene.addStanding({15.0 * 4.0 + kCarSize.length, 0.0, 0.0});
  EXPECT_EQ(scene.hits(), (std::vector<std::size_t>{0}));
}

TEST(FutureScorer, KeepsAMarginToOtherAgents) {
  for (const double side : {1.0, -1.0}) {
    Case scene = rearEnds({4.0});
    const double margin = scene.options.search.overlap_margin;
    scene.addStanding({30.0, side * (kCarSize.width + margin - 0.01), 0.0});
    EXPECT_EQ(scene.score().share, 0.0);
    scene.agents.clear();
    scene.addStanding({30.0, side * (kCarSize.width + margin + 0.01), 0.0});
    EXPECT_EQ(scene.score().share, 1.0);
  }
}

TEST(FutureScorer, ClosenessGrowsTowardsAHit) {
  const auto expect_growing = [](const std::vector<double>& closeness) {
    for (std::size_t i = 0; i < closeness.size(); ++i) {
      EXPECT_GE(closeness[i], 0.0);
      EXPECT_LE(closeness[i], 1.0);
      EXPECT_GT(closeness[i], i > 0 ? closeness[i - 1] : 0.0) << i;
    }
  };
  std::vector<double> in_time;
  std::vector<double> in_place;
  std::vector<double> in_heading;
  for (const double time : {1.0, 2.0, 3.0, 3.4})
    in_time.push_back(rearEnds({time}).score().closeness);
  for (const double beside : {5.0, 4.0, 3.0, 2.0}) {
    Case scene;
    scene.addEgo({0.0, beside, 0.0}, 15.0);
    in_place.push_back(scene.score().closeness);
  }
  for (const double yaw : {1.0, 0.6, 0.3}) {
    Case scene = rearEnds({4.2});
    for (AgentState& state : scene.egos[0].states) state.pose.yaw = yaw;
    EXPECT_EQ(scene.score().share, 0.0);
    in_heading.push_back(scene.score().closeness);
  }
  expect_growing(in_time);
  expect_growing(in_place);
  expect_growing(in_heading);
}

/// Egos of many speeds and places about a rear end, `count` of them.
Case spread(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Case scene;
  for (std::size_t i = 0; i < count; ++i) {
    scene.addEgo({10.0 + 30.0 * unit(random), 6.0 * unit(random) - 3.0, 0.3 * unit(random)},
                 4.0 + 10.0 * unit(random));
  }
  return scene;
}

TEST(FutureScorer, ScoresEachFutureIndependently) {
  const Case scene = spread(13, 1);
  double share = 0.0;
  double closeness = 0.0;
  for (std::size_t i = 0; i < scene.egos.size(); ++i) {
    Case alone = scene;
    alone.egos = {scene.egos[i]};
    share += alone.score().share / 13.0;
    closeness += alone.score().closeness / 13.0;
  }
  EXPECT_NEAR(scene.score().share, share, 1e-12);
  EXPECT_NEAR(scene.score().closeness, closeness, 0.02);
}

/// One random meeting of an attacker and an ego among other agents, and the result of verify().
class Meeting {
 public:
  explicit Meeting(unsigned seed) : random_(seed) {
    options_ = shippedOptions();
    // Limits that the scorer ignores.
    for (auto& [type, band] : request_.crash.types) band.max_approach = 2.0 * M_PI;
    for (auto& [type, band] : request_.crash.types) band.min_approach = 0.0;
    request_.crash.rules = seed % 3 == 0 ? TypeRules::kAngle : TypeRules::kFull;
    map_->driving_side = seed % 2 == 0 ? DrivingSide::kRight : DrivingSide::kLeft;
    request_.type = kCollisionTypes[seed % 5];
    request_.tta = between(1.0, 6.0);
    const TypeDefinition& band = request_.bands();
    const Pose2 start{between(-1000.0, 1000.0), between(-1000.0, 1000.0), between(-M_PI, M_PI)};
    const double speed = between(3.0, 15.0);
    const double ego_speed = between(0.0, 15.0);
    const double meet = request_.tta + between(-0.6, 0.6);
    const double sign = between(-1.0, 1.0) > 0.0 ? 1.0 : -1.0;
    const double heading = sign * between(band.min_heading - 0.05, band.max_heading + 0.05);
    // Steps so short that verify(), which tests between them, finds no other contact.
    options_.search.step = 0.01;
    drive_ = straightDrive(start, speed, 8.0, options_.search.step);
    const Pose2 met = compose(start, {speed * meet, 0.0, 0.0});
    const Pose2 ego = compose(met, {between(-5.0, 5.0), between(-3.0, 3.0), -heading});
    future_.ego =
        futureTrack(kEgoId, kEgoSize, compose(ego, {-ego_speed * meet, 0.0, 0.0}), ego_speed);
    const Pose2 beside = compose(start, {speed * between(0.0, 6.0), between(-15.0, 15.0), 0.0});
    others_ = {futureTrack("other", kCarSize, {beside.x, beside.y, between(-M_PI, M_PI)},
                           between(0.0, 8.0))};
  }

  bool isHit() const {
    const FutureScorer scorer({&future_.ego}, others_, request_, kNow, map_->driving_side,
                              options_);
    return scorer.score(Track{"attacker", AgentClass::kCar, kCarSize, {}}, drive_.points).share >
           0.0;
  }

  /// verify() with every border moved inwards (slack > 0) or outwards, for the boxes and for the
  /// shrunk ones.
  bool isVerified(double slack, double margin) const {
    CollisionRequest request = request_;
    request.crash.time_tolerance -= 0.25 * slack;
    TypeDefinition& band = request.crash.types.at(request.type);
    if (band.min_heading > 0.0) band.min_heading += 0.04 * slack;
    if (band.max_heading < 3.0) band.max_heading -= 0.04 * slack;
    AttackerTrajectory drive = drive_;
    Future future = future_;
    future.agents = others_;
    // Other agents grow so that one touched just after the contact is touched before it, and shrink
    // so that none is touched between two steps.
    for (Track& other : future.agents) {
      other.size.length += slack > 0.0 ? 5.0 : -1.0;
      other.size.width += slack > 0.0 ? 5.0 : -1.0;
    }
    for (BoxSize* size : {&drive.size, &future.ego.size}) {
      size->length -= 2.0 * margin;
      size->width -= 2.0 * margin;
    }
    Snapshot snapshot;
    snapshot.now = kNow;
    const CollisionReport report =
        verifyMotion(drive, {snapshot, future, request, LaneIndex(map_)}, options_.verification);
    return report.verified();
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  std::mt19937 random_;
  AttackOptions options_;
  std::shared_ptr<LaneMap> map_ = emptyMap();
  CollisionRequest request_ = requestFor();
  AttackerTrajectory drive_;
  Future future_;
  std::vector<Track> others_;
};

TEST(FutureScorer, AgreesWithVerificationAwayFromTheMargins) {
  const double margin = shippedOptions().search.overlap_margin;
  int hits = 0;
  int misses = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const Meeting meeting(seed);
    const auto agree = [&](double slack, bool verified) {
      return meeting.isVerified(slack, 0.0) == verified &&
             meeting.isVerified(slack, margin) == verified &&
             meeting.isVerified(slack, 2.0 * margin) == verified;
    };
    if (agree(1.0, true)) {
      ++hits;
      EXPECT_TRUE(meeting.isHit()) << "seed " << seed;
    } else if (agree(-1.0, false)) {
      ++misses;
      EXPECT_FALSE(meeting.isHit()) << "seed " << seed;
    }
  }
  EXPECT_GT(hits, 150);
  EXPECT_GT(misses, 1000);
}

}  // namespace
}  // namespace forge
