#include "properties/same_verdict.h"

#include <gtest/gtest.h>

#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

constexpr double kNoWay = 1e-3;  // m; a shorter step has no defined curvature

// Tolerances of contacts that are found from the same poses ...
constexpr double kContact = 1e-3;     // m between boxes that count as touching
constexpr double kExactTime = 1e-3;   // s
constexpr double kExactPlace = 1e-4;  // m, at the same instant
// ... and from poses that are interpolated between samples.
constexpr double kSampledTime = 0.1;    // s
constexpr double kSampledPlace = 0.05;  // m

/// The motion of the rear axle from one state to the next.
struct Step {
  double speed = 0.0;
  double curvature = 0.0;
};

Step stepBetween(const AgentState& a, const AgentState& b, double axle_to_middle) {
  const Pose2 from = compose(a.pose, {-axle_to_middle, 0.0, 0.0});
  const Pose2 to = compose(b.pose, {-axle_to_middle, 0.0, 0.0});
  const double turn = angleBetween(from.yaw, to.yaw);
  const double way =
      (to.position() - from.position()).dot(Pose2{0.0, 0.0, from.yaw + 0.5 * turn}.heading());
  return {way / (b.time - a.time), way > kNoWay ? turn / way : 0.0};
}

/// Returns points with speed, acceleration and curvature from the steps on either side; at both
/// ends from the nearest step.
std::vector<TrajectoryPoint> pointsThrough(const std::vector<AgentState>& states,
                                           double axle_to_middle) {
  std::vector<Step> steps;
  for (std::size_t i = 1; i < states.size(); ++i) {
    steps.push_back(stepBetween(states[i - 1], states[i], axle_to_middle));
  }
  const auto leadingTo = [](const Step& first, const Step& second) {
    return Step{2.0 * first.speed - second.speed, 2.0 * first.curvature - second.curvature};
  };
  steps.insert(steps.begin(), leadingTo(steps[0], steps[1]));
  steps.push_back(leadingTo(steps[steps.size() - 1], steps[steps.size() - 2]));
  std::vector<TrajectoryPoint> points;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Step &before = steps[i], &after = steps[i + 1];
    const double duration = states[1].time - states[0].time;
    points.push_back({states[i].time, states[i].pose, 0.5 * (before.speed + after.speed),
                      (after.speed - before.speed) / duration,
                      0.5 * (before.curvature + after.curvature)});
  }
  return points;
}

/// Returns the attacker's trajectory from t0 on, on the scene's clock.
AttackerTrajectory driveIn(const ReadCrash& read, const CrashRecord& written,
                           const AskedMoment& asked) {
  std::vector<AgentState> states;
  for (AgentState state : read.attacker.states) {
    if (state.time < written.now - kClock) continue;
    if (written.contact && state.time >= *written.contact - kClock) break;
    state.time += asked.now - written.now;
    states.push_back(state);
  }
  const std::size_t told = states.size();
  const AttackerTrajectory& attack = written.scenario.answer.trajectory;
  if (written.contact) {
    const double time = states.back().time + written.step;
    states.push_back({time, poseAt(attack, time)});
  }
  const double axle_to_middle =
      driveLimitsOf(written.attacker, embeddedConfig().attack.verification).axle_to_middle;
  std::vector<TrajectoryPoint> points = pointsThrough(states, axle_to_middle);
  for (std::size_t i = 1; read.tells_speeds && i < told; ++i) {  // the first point is recorded
    points[i].speed = states[i].velocity.dot(states[i].pose.heading());
  }
  return {attack.attacker_id, attack.agent_class, read.attacker.size, points, attack.past};
}

/// Compares everything except the place of the contact.
void expectSameVerdict(const CollisionReport& read, const CollisionReport& written,
                       double time_between) {
  EXPECT_EQ(read.verified(), written.verified()) << read.broken_limit;
  ASSERT_EQ(read.contact, written.contact);
  if (!written.contact) return;
  EXPECT_EQ(read.type_kept, written.type_kept);
  EXPECT_EQ(read.on_time, written.on_time);
  EXPECT_EQ(read.limits_kept, written.limits_kept) << read.broken_limit << written.broken_limit;
  EXPECT_EQ(read.first_other_id, written.first_other_id);
  EXPECT_EQ(read.believable(), written.believable()) << read.unbelievable << written.unbelievable;
  EXPECT_NEAR(read.contact_time, written.contact_time, time_between);
}

/// Returns the attacker's pose in the ego's frame.
Pose2 seenAt(const AttackerTrajectory& attack, const AskedMoment& asked, double time) {
  return relativeTo(stateAt(asked.recording->scene.ego, time).value().pose, poseAt(attack, time));
}

}  // namespace

void expectSameVerdict(const AttackerTrajectory& read, const AskedMoment& there,
                       const AttackerTrajectory& written, const AskedMoment& asked) {
  const CollisionReport found = testedReport(read, there), before = testedReport(written, asked);
  expectSameVerdict(found, before, kExactTime);
  if (!before.contact) return;
  const PatternMiss miss = missBetween(seenAt(written, asked, before.contact_time),
                                       seenAt(read, there, before.contact_time));
  EXPECT_LE(miss.distance, kExactPlace);
}

void expectSameCrash(const ReadCrash& read, const CrashRecord& written, const AskedMoment& asked) {
  AttackerTrajectory shown{read.attacker.id, read.attacker.agent_class, read.attacker.size, {}};
  for (const AgentState& state : read.attacker.states) {
    if (state.time < written.now - kClock) continue;
    shown.points.push_back({state.time, state.pose, 0.0, 0.0, 0.0});
  }
  const auto contact =
      firstContactTime(shown, read.ego, shown.points.back().time, kContact + kExactPlace);
  ASSERT_EQ(contact.has_value(), written.contact.has_value());
  if (!contact) return;
  EXPECT_NEAR(*contact, *written.contact, written.step + kClock);
  if (*written.contact < written.now + 2.0 * written.step) return;  // too short for speeds
  const CollisionReport found = testedReport(driveIn(read, written, asked), asked);
  const CollisionReport before = testedReport(written.scenario.answer.trajectory, asked);
  expectSameVerdict(found, before, kSampledTime);
  if (!found.contact || !before.contact) return;
  const PatternMiss miss =
      missBetween(relativeTo(before.ego_at_contact, before.attacker_at_contact),
                  relativeTo(found.ego_at_contact, found.attacker_at_contact));
  EXPECT_LE(miss.distance, kSampledPlace);
}

}  // namespace forge
