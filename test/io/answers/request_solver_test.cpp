#include "collision_forge/io/answers/request_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/verify/verification.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const std::string kDataroot = COLLISION_FORGE_SOURCE_DIR "/data/embedded";

/// Returns the scene with frames at `rate` (Hz) and linear motion between the recorded frames.
IndexedScene denser(const IndexedScene& recording, double rate) {
  IndexedScene dense = recording;
  Scene& scene = dense.scene;
  const std::vector<double> frames = std::move(scene.frame_times);
  scene.frame_times.clear();
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const double gap = frames[i + 1] - frames[i];
    const auto steps = static_cast<int>(std::lround(gap * rate));
    for (int j = 0; j < steps; ++j) scene.frame_times.push_back(frames[i] + gap * j / steps);
  }
  scene.frame_times.push_back(frames.back());
  for (Track& agent : scene.agents) {
    const Track recorded = agent;
    agent.states.clear();
    for (const double time : scene.frame_times) {
      if (const auto state = stateAt(recorded, time)) agent.states.push_back(*state);
    }
  }
  return dense;
}

class RequestSolverTest : public testing::Test {
 protected:
  /// A request 4 s after the first frame of scene-0001.
  SceneRequest asked(CollisionType type) {
    const double now = scenes_.at("scene-0001")->scene.frame_times.at(8);
    SceneRequest request{"scene-0001", now, {}};
    request.request.type = type;
    request.request.tta = 4.0;
    return request;
  }

  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  SceneSource scenes_{{kDataroot, "v1.0-embedded"}, {"scene-0001"}, config_, 1};
  const MethodMaker method_ = loadMethod("", config_, config_.attack);
  RequestSolver answerer_{scenes_, method_, config_.crash, config_.ego_vehicle, config_.adaptive};
};

TEST_F(RequestSolverTest, AgreesWithGenerateCollision) {
  const auto indexed = scenes_.at("scene-0001");
  for (const CollisionType type : kCollisionTypes) {
    const SceneRequest request = asked(type);
    const auto moment = std::get<Moment>(momentAt(*indexed, request.now, 8));
    Scenario expected{request, config_.ego_vehicle, {}};
    CollisionRequest crash = request.request;
    crash.crash = config_.crash;
    expected.answer = generateCollision(*method_.makeWithoutScene(request.scene), moment, crash,
                                        config_.attack.prediction);
    EXPECT_EQ(scenarioLine(answerer_.answer(request)), scenarioLine(expected));
  }
}

TEST_F(RequestSolverTest, AnyFrameRateGivesTheSameAttackersAndConfidences) {
  const auto recorded = scenes_.at("scene-0001");
  const auto method = method_.makeWithoutScene("scene-0001");
  int attacks = 0;
  for (const double rate : {10.0, 12.0, 20.0}) {
    const IndexedScene dense = denser(*recorded, rate);
    ASSERT_GT(dense.scene.frame_times.size(), 4 * recorded->scene.frame_times.size());
    for (const Mode mode : {Mode::kReplay, Mode::kHistory}) {
      for (const CollisionType type : kCollisionTypes) {
        CollisionRequest request = asked(type).request;
        request.crash = config_.crash;
        request.mode = mode;
        const auto answerAt = [&](const IndexedScene& scene) {
          const auto moment = std::get<Moment>(momentAt(scene, asked(type).now, 8));
          return generateCollision(*method, moment, request, config_.attack.prediction);
        };
        const Attack expected = answerAt(*recorded);
        const Attack attack = answerAt(dense);
        EXPECT_EQ(attack.status.code, expected.status.code) << rate << " Hz";
        EXPECT_EQ(attack.trajectory.attacker_id, expected.trajectory.attacker_id) << rate << " Hz";
        EXPECT_EQ(attack.report.confidence, expected.report.confidence) << rate << " Hz";
        attacks += expected.status.code == StatusCode::kOk;
      }
    }
  }
  EXPECT_GT(attacks, 6);
}

TEST_F(RequestSolverTest, AnAdaptiveAttackIsTheRequestedCrashOrRejected) {
  int attacks = 0;
  for (const CollisionType type : kCollisionTypes) {
    SceneRequest request = asked(type);
    request.request.mode = Mode::kAdaptive;
    const Scenario scenario = answerer_.answer(request);
    EXPECT_EQ(scenarioLine(answerer_.answer(request)), scenarioLine(scenario)) << "deterministic";
    EXPECT_EQ(scenario.plans.empty(), scenario.answer.status.code != StatusCode::kOk);
    if (scenario.answer.status.code != StatusCode::kOk) continue;
    ++attacks;
    const auto moment = std::get<Moment>(momentAt(*scenes_.at("scene-0001"), request.now, 8));
    request.request.crash = config_.crash;
    const CollisionReport report =
        verify(scenario.answer.trajectory,
               {moment.snapshot, *moment.recorded, request.request, *moment.lanes},
               config_.attack.verification);
    EXPECT_TRUE(report.verified()) << report.broken_limit;
    EXPECT_TRUE(report.believable()) << report.unbelievable;
  }
  EXPECT_GT(attacks, 0);
}

TEST_F(RequestSolverTest, RejectsATimeWithoutFrameNamingTheNearest) {
  SceneRequest request = asked(CollisionType::kRearEnd);
  const double frame = request.now;
  for (const double now : {frame + 0.1, frame - 0.1}) {
    request.now = now;
    const Status status = answerer_.answer(request).answer.status;
    EXPECT_EQ(status.code, StatusCode::kNoScene);
    EXPECT_NE(status.message.find(std::to_string(frame)), std::string::npos) << status.message;
  }
  request.now = frame + 5e-7;
  EXPECT_NE(answerer_.answer(request).answer.status.code, StatusCode::kNoScene) << "rounding";
}

}  // namespace
}  // namespace forge
