#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// A road with a lane each way that turns left by a quarter circle; right-hand traffic.
std::shared_ptr<LaneMap> bendingRoad() {
  constexpr double kRadius = 20.0;
  const auto on_road = [](double s, double lateral) -> Pose2 {
    const double turn = std::clamp(s / kRadius, 0.0, M_PI_2);
    const Pose2 start{kRadius * std::sin(turn), kRadius * (1.0 - std::cos(turn)), turn};
    return compose(start, {s - kRadius * turn, lateral, 0.0});
  };
  Lane there;
  there.id = "there";
  Lane back;
  back.id = "back";
  std::vector<Vector2> outline;
  std::vector<Vector2> other_side;
  for (int s = -100; s <= 130; s += 2) {
    there.centerline.push_back(on_road(s, -1.75));
    back.centerline.push_back(compose(on_road(30 - s, 1.75), {0.0, 0.0, M_PI}));
    outline.push_back(on_road(s, -3.5).position());
    other_side.push_back(on_road(s, 3.5).position());
  }
  outline.insert(outline.end(), other_side.rbegin(), other_side.rend());
  auto map = emptyMap();
  map->lanes = {there, back};
  map->drivable_area = {{outline, {}}};
  return map;
}

/// A random request in random traffic on one of three maps.
class RandomRequest {
 public:
  explicit RandomRequest(std::uint32_t seed) : random_(seed) {
    static const std::array<std::shared_ptr<LaneMap>, 3> kMaps = {twoLaneRoad(), fourWayJunction(),
                                                                  bendingRoad()};
    map_ = kMaps[seed % kMaps.size()];
    const double ego_speed = between(0.0, 15.0);
    // Before the junction or the bend, where there is one.
    const Pose2 ego =
        onLane(map_->lanes[0], map_->lanes.size() > 2 ? between(0.75, 0.95) : between(0.3, 0.5));
    snapshot_ = snapshotOf(pastTrack(kEgoId, kEgoSize, ego, ego_speed), {}, map_);
    recorded_.ego = futureTrack(kEgoId, kEgoSize, ego, ego_speed);
    const int agents = 1 + static_cast<int>(between(0.0, 4.0));
    for (int i = 0; i < agents; ++i) addAgent("agent" + std::to_string(i), ego);
    request_.type = kCollisionTypes[static_cast<std::size_t>(between(0.0, 5.0))];
    request_.tta = between(0.5, 7.0);
    request_.mode = between(0.0, 1.0) < 0.5 ? Mode::kHistory : Mode::kReplay;
    request_.seed = seed;
  }

  Realization answer() const {
    AttackOptions options = shippedOptions();
    // Fewer trials: there are many requests, and none has to be met.
    options.search.bicycle_targets = 20;
    options.search.bicycle_rounds = 2;
    options.search.bicycle_perturbations = 20;
    const Moment moment{snapshot_, recorded_, std::make_shared<const LaneIndex>(map_)};
    return generateCollision(searchMethod(options), moment, request_, options.prediction);
  }
  const AgentState& now(const std::string& attacker) const {
    return std::find_if(snapshot_.agents.begin(), snapshot_.agents.end(),
                        [&](const Track& agent) { return agent.id == attacker; })
        ->states.back();
  }
  const CollisionRequest& request() const { return request_; }

 private:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

  Pose2 onLane(const Lane& lane, double share) {
    const auto count = static_cast<double>(lane.centerline.size() - 2);
    const Pose2 place = lane.centerline[static_cast<std::size_t>(share * count)];
    return compose(place, {0.0, between(-0.5, 0.5), between(-0.05, 0.05)});
  }

  /// On a lane or anywhere about the ego; one in five stands.
  void addAgent(const std::string& id, const Pose2& ego) {
    const BoxSize size{between(3.5, 9.0), between(1.6, 2.5)};
    const double speed = between(0.0, 1.0) < 0.2 ? 0.0 : between(0.0, 15.0);
    const auto lane =
        static_cast<std::size_t>(between(0.0, static_cast<double>(map_->lanes.size())));
    const Pose2 pose =
        between(0.0, 1.0) < 0.7
            ? onLane(map_->lanes[lane], between(0.35, 0.65))
            : compose(ego, {between(-50.0, 50.0), between(-20.0, 20.0), between(-M_PI, M_PI)});
    snapshot_.agents.push_back(pastTrack(id, size, pose, speed));
    recorded_.agents.push_back(futureTrack(id, size, pose, speed));
  }

  std::mt19937 random_;
  std::shared_ptr<LaneMap> map_;
  Snapshot snapshot_;
  Future recorded_;
  CollisionRequest request_ = requestFor();
};

/// Holds positions and headings alone against what a car can do, by differences.
class LimitChecker {
 public:
  explicit LimitChecker(const std::vector<TrajectoryPoint>& points, double until) {
    for (const TrajectoryPoint& point : points) {
      path_.push_back({point.time, point.pose.x, point.pose.y, point.pose.yaw});
      if (point.time >= until) break;
    }
  }

  /// What is broken, one entry a limit; empty if all are kept.
  std::vector<std::string> broken() {
    for (std::size_t i = 1; i < path_.size(); ++i) checkStep(path_[i - 1], path_[i]);
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      checkAcceleration(path_[i - 1], path_[i], path_[i + 1]);
    }
    checkSlowTurns();
    return broken_;
  }

  double startSpeed() const {
    return std::hypot(path_[1].x - path_[0].x, path_[1].y - path_[0].y) /
           (path_[1].time - path_[0].time);
  }

 private:
  struct Sample {
    double time, x, y, yaw;
  };

  // What a car can do, as config/vehicle_limits.yaml has it.
  static constexpr double kMaxSpeed = 25.0;
  static constexpr double kMaxForward = 5.0;
  static constexpr double kMaxBraking = 8.0;
  static constexpr double kMaxTotal = 8.0;
  static constexpr double kMaxCurvature = 0.2;
  static constexpr double kSlow = 2.0;
  static constexpr double kSlack = 0.1745;
  static constexpr double kPerMetre = 0.3;
  // What differences may be off.
  static constexpr double kAccelerationError = 0.1;  // m/s2; jerk
  static constexpr double kCurvatureError = 0.015;   // 1/m
  static constexpr double kSlipError = 0.05;         // rad between motion and heading
  static constexpr double kBackwards = 1e-3;         // m
  static constexpr double kRounding = 1e-6;

  static double turn(double from, double to) {
    return std::atan2(std::sin(to - from), std::cos(to - from));
  }
  static double length(const Sample& a, const Sample& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
  }
  static double speed(const Sample& a, const Sample& b) { return length(a, b) / (b.time - a.time); }

  void check(bool kept, const std::string& limit, double value, double time) {
    if (kept) return;
    broken_.push_back(limit + " " + std::to_string(value) + " at " + std::to_string(time - kNow));
  }

  void checkStep(const Sample& a, const Sample& b) {
    check(speed(a, b) <= kMaxSpeed + kRounding, "speed", speed(a, b), a.time);
    const double forward = (b.x - a.x) * std::cos(a.yaw) + (b.y - a.y) * std::sin(a.yaw);
    check(forward >= -kBackwards - kRounding, "reversing", forward, a.time);
    if (speed(a, b) < 1.1 * kSlow) return;
    const double curvature = std::abs(turn(a.yaw, b.yaw)) / length(a, b);
    check(curvature <= kMaxCurvature + kCurvatureError, "curvature", curvature, a.time);
    const double middle = a.yaw + 0.5 * turn(a.yaw, b.yaw);
    const double slip = std::abs(turn(middle, std::atan2(b.y - a.y, b.x - a.x)));
    check(slip <= kSlipError, "slip", slip, a.time);
  }

  void checkAcceleration(const Sample& a, const Sample& b, const Sample& c) {
    const double step = 0.5 * (c.time - a.time);
    const double x = (c.x - 2.0 * b.x + a.x) / (step * step);
    const double y = (c.y - 2.0 * b.y + a.y) / (step * step);
    const double along = x * std::cos(b.yaw) + y * std::sin(b.yaw);
    check(along <= kMaxForward + kAccelerationError, "forward", along, b.time);
    check(along >= -kMaxBraking - kAccelerationError, "braking", along, b.time);
    check(std::hypot(x, y) <= kMaxTotal + kAccelerationError, "total", std::hypot(x, y), b.time);
  }

  /// Headings against that where the slow stretch began, wherever it is surely slow.
  void checkSlowTurns() {
    std::size_t begin = 0;
    double driven = 0.0;
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
      const double now = speed(path_[i], path_[i + 1]);
      if (now >= 1.1 * kSlow) {
        begin = i;
        driven = 0.0;
      }
      driven += length(path_[i], path_[i + 1]);
      if (now > 0.85 * kSlow) continue;
      const double turned = std::abs(turn(path_[begin].yaw, path_[i + 1].yaw));
      const bool kept = turned <= kSlack + kPerMetre * driven + kRounding;
      check(kept, "slow turn", turned, path_[i].time);
    }
  }

  std::vector<Sample> path_;
  std::vector<std::string> broken_;
};

TEST(LimitsKept, EveryAttackKeepsTheVehicleLimitsByItsPositionsAndHeadings) {
  std::array<int, 5> answered{};
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    const RandomRequest random(seed);
    const Realization answer = random.answer();
    if (answer.status.code != StatusCode::kOk) continue;
    ++answered.at(static_cast<std::size_t>(random.request().type));
    LimitChecker checker(answer.trajectory.points, answer.report.contact_time);
    for (const std::string& broken : checker.broken()) {
      ADD_FAILURE() << "seed " << seed << ", " << toString(random.request().type) << ", tta "
                    << random.request().tta << ": " << broken;
    }
    const AgentState& now = random.now(answer.trajectory.attacker_id);
    const TrajectoryPoint& start = answer.trajectory.points.front();
    EXPECT_NEAR((start.pose.position() - now.pose.position()).norm(), 0.0, 0.05) << seed;
    EXPECT_NEAR(angleBetween(now.pose.yaw, start.pose.yaw), 0.0, 0.1745 + 1e-9) << seed;
    EXPECT_NEAR(checker.startSpeed(), now.velocity.norm(), 0.9) << seed;
  }
  for (const CollisionType type : kCollisionTypes) {
    EXPECT_GT(answered.at(static_cast<std::size_t>(type)), 20)
        << toString(type) << ": too few answers to mean anything";
  }
}

}  // namespace
}  // namespace forge
