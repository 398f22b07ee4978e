#include "collision_forge/attack/search/search_method.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/kinematic_prediction.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/realizer.h"

namespace forge {
namespace {

/// A scene to ask for collisions in.
struct Case {
  AttackOptions options = shippedOptions();
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  Snapshot snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                                 {pastTrack("behind", kCarSize, {-20.0, 0.2, 0.0}, 12.0),
                                  pastTrack("oncoming", kCarSize, {75.0, 3.5, M_PI}, 10.0)},
                                 map);
  CollisionRequest request = requestFor();
  std::optional<Future> recorded;

  Realization result() const {
    const Moment moment{snapshot, recorded, std::make_shared<const LaneIndex>(map)};
    return generateCollision(searchMethod(options), moment, request, options.prediction);
  }
  /// The future used for verification: the recorded one, or the predicted one in which the ego is
  /// where the report has it.
  Future futureOf(const Realization& answer) const {
    if (request.mode == Mode::kReplay) return *recorded;
    Future future =
        kinematicPredictor(options).predict(snapshot, LaneIndex(map), request, nullptr).future;
    for (const Track& sample : future.ego_samples) {
      const auto state = stateAt(sample, answer.report.contact_time);
      if (!state) continue;
      const Pose2 apart = relativeTo(state->pose, answer.report.ego_at_contact);
      if (apart.position().norm() > 1e-6 || std::abs(apart.yaw) > 1e-6) continue;
      future.ego = sample;
      return future;
    }
    ADD_FAILURE() << "the ego of the report is in no predicted future";
    return future;
  }
  void expectRefusal(StatusCode code, const std::vector<std::string>& parts) const {
    const Status status = result().status;
    EXPECT_STREQ(toString(status.code), toString(code)) << status.message;
    for (const std::string& part : parts) {
      EXPECT_NE(status.message.find(part), std::string::npos) << part << ": " << status.message;
    }
  }
};

Future straightFuture() {
  Future future;
  future.ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
  future.agents = {futureTrack("behind", kCarSize, {-20.0, 0.2, 0.0}, 12.0)};
  return future;
}

/// Every number of a trajectory, bit by bit.
std::string bytesOf(const AttackerTrajectory& trajectory) {
  std::string bytes = trajectory.attacker_id;
  for (const TrajectoryPoint& point : trajectory.points) {
    const std::array<double, 7> numbers = {point.time,     point.pose.x, point.pose.y,
                                           point.pose.yaw, point.speed,  point.acceleration,
                                           point.curvature};
    std::array<char, sizeof(numbers)> raw{};
    std::memcpy(raw.data(), numbers.data(), sizeof(numbers));
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

TEST(GenerateCollision, ReturnsAVerifiedAttack) {
  Case scene;
  const Realization history = scene.result();
  EXPECT_EQ(history.status.code, StatusCode::kOk) << history.status.message;
  EXPECT_EQ(history.status.message, "");
  EXPECT_TRUE(history.report.verified());
  EXPECT_GT(history.report.confidence, 0.0);
  scene.request.mode = Mode::kReplay;
  scene.recorded = straightFuture();
  const Realization replay = scene.result();
  EXPECT_EQ(replay.status.code, StatusCode::kOk) << replay.status.message;
  EXPECT_EQ(replay.report.confidence, 1.0);
}

TEST(GenerateCollision, UsesTheRecordingInReplayOnly) {
  Case scene;
  const std::string blind = bytesOf(scene.result().trajectory);
  scene.recorded = straightFuture();
  scene.recorded->ego = futureTrack(kEgoId, kEgoSize, {}, 5.0);
  EXPECT_EQ(bytesOf(scene.result().trajectory), blind);
  scene.request.mode = Mode::kReplay;
  EXPECT_NE(bytesOf(scene.result().trajectory), blind);
}

TEST(GenerateCollision, UsesTheRequestedAttacker) {
  Case scene;
  scene.request.type = CollisionType::kOppositeDirection;
  scene.request.attacker = "oncoming";
  const Realization result = scene.result();
  ASSERT_EQ(result.status.code, StatusCode::kOk) << result.status.message;
  EXPECT_EQ(result.trajectory.attacker_id, "oncoming");
}

TEST(GenerateCollision, RejectsReplayWithoutARecording) {
  Case scene;
  scene.request.mode = Mode::kReplay;
  scene.expectRefusal(StatusCode::kNoRecording, {"mode", "replay"});
}

TEST(GenerateCollision, SameSeedSameBytes) {
  for (const std::uint64_t seed : {0ull, 7ull, 18446744073709551615ull}) {
    Case scene;
    scene.request.seed = seed;
    const Realization first = scene.result();
    const Realization second = scene.result();
    ASSERT_EQ(first.status.code, StatusCode::kOk);
    EXPECT_EQ(bytesOf(first.trajectory), bytesOf(second.trajectory));
    EXPECT_EQ(first.report.contact_time, second.report.contact_time);
    EXPECT_EQ(first.report.confidence, second.report.confidence);
  }
}

/// An independent check of an attack that shares no code with the sources: millimetre steps, its
/// own separating axes and interpolation, limits from differences of positions.
class BruteForce {
 public:
  BruteForce(const Realization& answer, const Future& future) : answer_(answer), future_(future) {
    for (const TrajectoryPoint& point : answer.trajectory.points) {
      path_.push_back({point.time, point.pose.x, point.pose.y, point.pose.yaw});
    }
  }

  /// Adds a failure for each error of the attack.
  void check(const CollisionRequest& request, const Track& attacker) const {
    checkContacts();
    checkType(request);
    checkStart(attacker);
    checkLimits();
  }

 private:
  struct Sample {
    double time, x, y, yaw;
  };
  struct Box {
    double x, y, yaw, half_length, half_width;
  };

  static double turn(double from, double to) {
    return std::atan2(std::sin(to - from), std::cos(to - from));
  }

  static std::optional<Sample> at(const std::vector<Sample>& samples, double time) {
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const Sample& a = samples[i];
      const Sample& b = samples[i + 1];
      if (time < a.time || time > b.time || b.time - a.time > 1.1) continue;
      const double ratio = (time - a.time) / (b.time - a.time);
      return Sample{time, a.x + ratio * (b.x - a.x), a.y + ratio * (b.y - a.y),
                    a.yaw + ratio * turn(a.yaw, b.yaw)};
    }
    return std::nullopt;
  }

  static std::vector<Sample> samplesOf(const Track& track) {
    std::vector<Sample> samples;
    for (const AgentState& state : track.states) {
      samples.push_back({state.time, state.pose.x, state.pose.y, state.pose.yaw});
    }
    return samples;
  }

  static std::array<std::array<double, 2>, 4> cornersOf(const Box& box) {
    const double c = std::cos(box.yaw);
    const double s = std::sin(box.yaw);
    std::array<std::array<double, 2>, 4> result;
    for (int i = 0; i < 4; ++i) {
      const double l = i < 2 ? box.half_length : -box.half_length;
      const double w = i == 0 || i == 3 ? box.half_width : -box.half_width;
      result[static_cast<std::size_t>(i)] = {box.x + c * l - s * w, box.y + s * l + c * w};
    }
    return result;
  }

  static bool overlap(const Box& a, const Box& b) {
    for (const double yaw : {a.yaw, a.yaw + M_PI_2, b.yaw, b.yaw + M_PI_2}) {
      double a_min = 1e18, a_max = -1e18, b_min = 1e18, b_max = -1e18;
      for (const auto& corner : cornersOf(a)) {
        const double shadow = corner[0] * std::cos(yaw) + corner[1] * std::sin(yaw);
        a_min = std::min(a_min, shadow);
        a_max = std::max(a_max, shadow);
      }
      for (const auto& corner : cornersOf(b)) {
        const double shadow = corner[0] * std::cos(yaw) + corner[1] * std::sin(yaw);
        b_min = std::min(b_min, shadow);
        b_max = std::max(b_max, shadow);
      }
      if (a_max < b_min || b_max < a_min) return false;
    }
    return true;
  }

  /// Overlap of attacker and track at a time, the track's box grown by `margin` all around.
  bool touches(const std::vector<Sample>& track, const BoxSize& size, double time,
               double margin) const {
    const auto other = at(track, time);
    const auto own = at(path_, time);
    if (!other || !own) return false;
    const BoxSize& own_size = answer_.trajectory.size;
    return overlap(
        {own->x, own->y, own->yaw, 0.5 * own_size.length, 0.5 * own_size.width},
        {other->x, other->y, other->yaw, 0.5 * size.length + margin, 0.5 * size.width + margin});
  }

  void checkContacts() const {
    const double contact = answer_.report.contact_time;
    const std::vector<Sample> ego = samplesOf(future_.ego);
    EXPECT_GT(contact, kNow);
    EXPECT_TRUE(touches(ego, future_.ego.size, contact, 2e-3)) << "no contact as reported";
    for (double time = kNow; time < contact - 1e-6; time += 1e-3) {
      if (!touches(ego, future_.ego.size, time, -1e-3)) continue;
      ADD_FAILURE() << "ego touched " << contact - time << " s early";
      break;
    }
    for (const Track& other : future_.agents) {
      if (other.id == answer_.trajectory.attacker_id) continue;
      const std::vector<Sample> samples = samplesOf(other);
      for (double time = kNow; time < contact - 1e-6; time += 1e-3) {
        if (!touches(samples, other.size, time, -2e-3)) continue;
        ADD_FAILURE() << other.id << " touched before the ego";
        break;
      }
    }
  }

  void checkType(const CollisionRequest& request) const {
    const double contact = answer_.report.contact_time;
    const double heading =
        std::abs(turn(at(samplesOf(future_.ego), contact)->yaw, at(path_, contact)->yaw));
    const TypeDefinition& band = request.bands();
    EXPECT_GE(heading, band.min_heading - 1e-9);
    EXPECT_LE(heading, band.max_heading + 1e-9);
    const double approach = std::abs(turn(future_.ego.states.front().pose.yaw, path_[0].yaw));
    EXPECT_GE(approach, band.min_approach - 1e-9);
    EXPECT_LE(approach, band.max_approach + 1e-9);
    EXPECT_LE(std::abs(contact - kNow - request.tta), request.crash.time_tolerance + 1e-9);
  }

  void checkStart(const Track& attacker) const {
    const AgentState& now = attacker.states.back();
    EXPECT_NEAR(path_[0].time, kNow, 1e-9);
    EXPECT_NEAR(std::hypot(path_[0].x - now.pose.x, path_[0].y - now.pose.y), 0.0, 1e-6);
    EXPECT_LE(std::abs(turn(now.pose.yaw, path_[0].yaw)), 0.1745 + 1e-9);
    const double step = path_[1].time - path_[0].time;
    const double vx = (path_[1].x - path_[0].x) / step;
    const double vy = (path_[1].y - path_[0].y) / step;
    EXPECT_LE(std::hypot(vx - now.velocity.x(), vy - now.velocity.y()), 8.5 * step)
        << "it starts with another velocity than it has";
  }

  /// Differences over a step average what the limits bound, but the jerk of a short attack moves
  /// the average between samples: hence the margins.
  void checkLimits() const {
    constexpr double kMargin = 0.4;  // m/s2
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      const Sample& a = path_[i - 1];
      const Sample& b = path_[i];
      const Sample& c = path_[i + 1];
      if (c.time > answer_.report.contact_time) break;
      const double step = b.time - a.time;
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const double ax = (c.x - 2.0 * b.x + a.x) / (step * step);
      const double ay = (c.y - 2.0 * b.y + a.y) / (step * step);
      const double along = ax * std::cos(b.yaw) + ay * std::sin(b.yaw);
      EXPECT_LE(length / step, 25.0 + 0.1);
      EXPECT_LE(std::hypot(ax, ay), 8.0 + kMargin);
      EXPECT_LE(along, 5.0 + kMargin);
      EXPECT_GE(along, -8.0 - kMargin);
      const double forward = (b.x - a.x) * std::cos(b.yaw) + (b.y - a.y) * std::sin(b.yaw);
      EXPECT_GE(forward, -1e-3 - 0.02 * length) << "reversing";
      const double slip = turn(a.yaw + 0.5 * turn(a.yaw, b.yaw), std::atan2(b.y - a.y, b.x - a.x));
      if (length / step < 2.2) continue;
      EXPECT_LE(std::abs(turn(a.yaw, b.yaw)) / length, 0.2 * 1.05 + 0.005);
      EXPECT_LE(std::abs(slip), 0.05) << "sliding sideways";
    }
  }

  const Realization& answer_;
  const Future& future_;
  std::vector<Sample> path_;
};

/// Random traffic on the two maps; some agents have gaps, some are no vehicles.
class RandomScene {
 public:
  explicit RandomScene(std::uint32_t seed) : random_(seed) {
    scene_.map = seed % 2 == 0 ? twoLaneRoad() : fourWayJunction();
    const double ego_speed = between(0.0, 15.0);
    const Pose2 ego{between(-50.0, 0.0), seed % 2 == 0 ? 0.0 : -1.75, between(-0.05, 0.05)};
    scene_.snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, ego, ego_speed), {}, scene_.map);
    scene_.recorded = Future{futureTrack(kEgoId, kEgoSize, ego, ego_speed), {}, {}};
    scene_.request.type = kCollisionTypes[static_cast<std::size_t>(between(0.0, 5.0))];
    scene_.request.tta = between(0.5, 7.0);
    const int agents = static_cast<int>(between(0.0, 6.0));
    for (int i = 0; i < agents; ++i) addAgent("agent" + std::to_string(i), anywhereNear(ego));
    // Oncoming, at an ordinary speed away from where the ego will be.
    const double impact = ego.x + ego_speed * scene_.request.tta;
    addAgent("oncoming", {impact + between(5.0, 8.0) * scene_.request.tta, between(2.0, 8.0),
                          M_PI + between(-0.2, 0.2)});
    scene_.request.mode = between(0.0, 1.0) < 0.5 ? Mode::kHistory : Mode::kReplay;
    scene_.request.seed = seed;
  }

  const Case& scene() const { return scene_; }

 private:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }

  Pose2 anywhereNear(const Pose2& ego) {
    return {ego.x + between(-60.0, 60.0), ego.y + between(-25.0, 25.0),
            M_PI_2 * std::floor(between(0.0, 4.0)) + between(-0.2, 0.2)};
  }

  void addAgent(const std::string& id, const Pose2& pose) {
    const BoxSize size{between(3.5, 10.0), between(1.6, 2.6)};
    const double speed = between(0.0, 1.0) < 0.2 ? 0.0 : between(0.0, 15.0);
    Track past = pastTrack(id, size, pose, speed);
    Track rest = futureTrack(id, size, pose, speed);
    if (between(0.0, 1.0) < 0.2) past.agent_class = rest.agent_class = AgentClass::kBicycle;
    if (between(0.0, 1.0) < 0.2)
      rest.states.erase(rest.states.begin() + 3, rest.states.begin() + 7);
    if (between(0.0, 1.0) < 0.2) rest.states.resize(5);
    scene_.snapshot.agents.push_back(past);
    scene_.recorded->agents.push_back(rest);
  }

  std::mt19937 random_;
  Case scene_;
};

TEST(GenerateCollision, EveryAttackPassesABruteForceCheck) {
  std::map<CollisionType, int> answered;
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    const RandomScene random(seed);
    const Case& scene = random.scene();
    const Realization answer = scene.result();
    if (answer.status.code != StatusCode::kOk) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + toString(scene.request.type) + ", tta " +
                 std::to_string(scene.request.tta) + ", " + toString(scene.request.mode));
    ++answered[scene.request.type];
    const auto& agents = scene.snapshot.agents;
    const auto attacker = std::find_if(agents.begin(), agents.end(), [&](const Track& agent) {
      return agent.id == answer.trajectory.attacker_id;
    });
    ASSERT_NE(attacker, agents.end());
    BruteForce(answer, scene.futureOf(answer)).check(scene.request, *attacker);
  }
  for (const CollisionType type : kCollisionTypes) {
    EXPECT_GE(answered[type], 6) << toString(type) << ": too few answers to mean anything";
  }
}

TEST(SearchMethod, UsesAnyBelievableMotionIfNoRouteLeadsToAnAttack) {
  Case scene;
  scene.request = believableRequestFor(CollisionType::kRearEnd);
  scene.request.choice = AttackerChoice::kExisting;
  const Realization along = scene.result();
  ASSERT_EQ(along.status.code, StatusCode::kOk) << along.status.message;
  scene.options.route.ways = 0;  // so that no route leads to the ego
  for (const auto& choice : {AttackerChoice::kExisting, AttackerChoice::kAny}) {
    scene.request.choice = choice;
    const Realization answer = scene.result();
    ASSERT_EQ(answer.status.code, StatusCode::kOk) << answer.status.message;
    EXPECT_TRUE(isAsAsked(answer.report, scene.request));
    EXPECT_TRUE(answer.report.believable()) << answer.report.unbelievable;
  }
}

TEST(SearchMethod, ReportsThatTheRoadDoesNotAllowForAnyChoice) {
  Case scene;
  scene.request = believableRequestFor(CollisionType::kJunctionCrossing);
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    scene.request.choice = choice;
    scene.expectRefusal(StatusCode::kRoadDoesNotAllow, {"junction crossing"});
  }
  scene.request.crash.believable = false;
  scene.expectRefusal(StatusCode::kNoCandidate, {"believable = true"});
}

}  // namespace
}  // namespace forge
