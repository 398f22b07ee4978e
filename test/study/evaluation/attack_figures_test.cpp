#include "collision_forge/study/evaluation/attack_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const StudyConfig& shipped() {
  static const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

/// A recorded vehicle that drives along x at `speed` until 5 s after t0.
Track drive(const std::string& id, const Pose2& now, double speed, int first = -20) {
  Track track{id, AgentClass::kCar, kCarSize, {}};
  for (int i = first; i <= 10; ++i) {
    const Pose2 pose = compose(now, {0.5 * i * speed, 0.0, 0.0});
    track.states.push_back({kNow + 0.5 * i, pose, speed * now.heading()});
  }
  return track;
}

/// "attacker" at 10 m/s along x with a contact after 4 s, "beside" 5 m to its left.
struct Case {
  Scene recording;
  Realization answer;

  Case() {
    recording.name = "scene";
    recording.ego = drive(kEgoId, {60.0, 0.0, 0.0}, 5.0);
    recording.agents = {drive("attacker", {}, 10.0), drive("beside", {0.0, 5.0, 0.0}, 10.0)};
    answer.trajectory = straightDrive({}, 10.0, 6.0);
    answer.report.contact = true;
    answer.report.contact_time = kNow + 4.0;
    answer.report.road.on_lane = 0.75;
  }

  AttackFigures figures() const { return attackFigures(answer, recording, shipped()); }
};

TEST(AttackFigures, WindowEndsBeforeTheContactOfTheReport) {
  const AttackFigures figures = Case().figures();
  EXPECT_EQ(figures.attacker_id, "attacker");
  EXPECT_EQ(figures.road.on_lane, 0.75);
  ASSERT_TRUE(figures.window);
  EXPECT_EQ(figures.window->scene, "scene");
  EXPECT_NEAR(figures.window->samples.back().time, kNow + 2.5, 1e-9);
  EXPECT_EQ(figures.window->generated, 5u);
}

TEST(AttackFigures, AnAddedAttackerUsesItsOwnPast) {
  Case c;
  c.recording.agents.erase(c.recording.agents.begin());
  EXPECT_FALSE(c.figures().window);
  c.answer.trajectory.past = drive("attacker", {}, 10.0).states;
  c.answer.trajectory.past.resize(21);
  ASSERT_TRUE(c.answer.trajectory.isAdded());
  EXPECT_TRUE(c.figures().window);
}

TEST(AttackFigures, LeastGapExcludesTheEgoAndEndsAtTheContact) {
  Case c;
  EXPECT_NEAR(*c.figures().least_gap, 5.0 - kCarSize.width, 1e-9);
  // Stands at the position of the attacker's front at 4.5 s, half a second after the contact.
  const double ahead = 45.0 + kCarSize.length;
  c.recording.agents.push_back(drive("standing", {ahead, 0.0, 0.0}, 0.0));
  EXPECT_NEAR(*c.figures().least_gap, 5.0 - kCarSize.width, 1e-9);
  c.answer.report.contact_time = kNow + 4.4;
  EXPECT_NEAR(*c.figures().least_gap, 1.0, 1e-6);
  c.recording.agents.resize(1);
  EXPECT_FALSE(c.figures().least_gap);
}

TEST(AttackFigures, PeaksEndAtTheContact) {
  Case c;
  for (TrajectoryPoint& point : c.answer.trajectory.points) {
    const double after = point.time - kNow;
    point.curvature = after < 4.05 ? 0.01 * after : 1.0;
    point.acceleration = after < 4.05 ? -0.5 * after : 50.0;
  }
  const AttackFigures figures = c.figures();
  const double wheelbase =
      driveLimitsOf(AgentClass::kCar, kCarSize, shipped().attack.verification.drivable).wheelbase;
  EXPECT_NEAR(figures.peaks.lateral_acceleration, 100.0 * 0.04, 1e-6);
  EXPECT_NEAR(figures.peaks.jerk, 0.5, 1e-6);
  EXPECT_NEAR(figures.peaks.steering_rate, 0.01 * wheelbase, 1e-4);
}

TEST(AttackFigures, ColumnsRoundTrip) {
  Case c;
  c.answer.report.road = {0.1, 0.2, 0.3, 0.4, 0.5};
  const std::optional<AttackFigures> attack = c.figures();
  const std::vector<std::string> columns = attackColumns(attack);
  const std::string header = attackHeader();
  EXPECT_EQ(columns.size(),
            1 + static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')));
  std::optional<AttackFigures> copy;
  ASSERT_TRUE(readAttackColumns(columns, "scene", copy));
  EXPECT_EQ(attackColumns(copy), columns);
  EXPECT_EQ(copy->agent_class, AgentClass::kCar);
  EXPECT_EQ(copy->road.on_island, 0.5);
  ASSERT_TRUE(copy->window);
  EXPECT_EQ(copy->window->scene, "scene");
  EXPECT_EQ(copy->window->generated, attack->window->generated);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    EXPECT_NEAR(copy->window->samples[i].time, attack->window->samples[i].time, 1e-6);
    EXPECT_NEAR(copy->window->samples[i].pose.x, attack->window->samples[i].pose.x, 1e-3);
  }
}

TEST(RecordedMotion, HasEachWindowWithRoadUseAndGap) {
  const Case c;
  const auto map = twoLaneRoad();
  IndexedScene recording{c.recording, std::make_shared<const LaneIndex>(map)};
  recording.scene.agents[1] = drive("beside", {0.0, 40.0, 0.0}, 10.0);
  const auto motions = recordedMotion(recording, shipped());
  // Two vehicles with 31 states each.
  ASSERT_EQ(motions.size(), 2u * (31 - kWindowSamples + 1));
  const auto on_lane = [](const RecordedMotion& motion) { return motion.road.on_lane; };
  EXPECT_GT(on_lane(motions.front()), 0.0);
  EXPECT_EQ(on_lane(motions.back()), 0.0);
  // The attacker approaches the ego: 60 - 5 t between the centres, t = 5 s at the end.
  const MotionWindow& last = motions[31 - kWindowSamples].window;
  EXPECT_EQ(last.id, "attacker");
  const double reach = 0.5 * (kCarSize.length + recording.scene.ego.size.length);
  EXPECT_NEAR(*motions[31 - kWindowSamples].least_gap, 35.0 - reach, 1e-6);
}

}  // namespace
}  // namespace forge
