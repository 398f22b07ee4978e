// Round trips of attacks (scenario files, bag messages, clips) and of requests: what was written is
// read back equal, and verification gives the same verdict.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/io/collide/collide_export.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/study/evaluation/published.h"
#include "io/logs/nuscenes_fixture.h"
#include "properties/plane_change.h"
#include "properties/same_verdict.h"

namespace forge {
namespace {

constexpr double kSamePlace = 1e-6;  // m and rad

PublishedOutcome outcomeOf(const CollideClip& clip) {
  std::vector<Pose2> attacker;
  for (const auto& state : clip.attacker().frames) attacker.push_back(state->pose);
  return publishedOutcome(clip, attacker, embeddedConfig().evaluation.published);
}

/// Writes and reads a scenario: expects the same line, and the same verdict of its attack. Returns
/// the scenario read.
Scenario expectSameLineAndVerdict(const Scenario& scenario, const AskedMoment& asked) {
  const std::string line = scenarioLine(scenario);
  Scenario read = readScenarioLine("here", line, embeddedConfig().input_limits);
  EXPECT_EQ(scenarioLine(read), line);
  if (scenario.answer.status.code == StatusCode::kOk) {
    expectSameVerdict(read.answer.trajectory, scenario.answer.trajectory, asked);
  }
  return read;
}

TEST(AnswersReadBack, ScenarioLinesKeepTheVerdict) {
  forChangedAnswers(
      kBothModes, anyChange,
      [](const AskedMoment& asked, const Scenario& scenario, const PlaneChange& change) {
        expectSameLineAndVerdict(change.scenario(scenario), change.asked(asked));
      });
}

TEST(AnswersReadBack, AdaptiveScenarioLinesKeepTheRequest) {
  forChangedAnswers(
      {Mode::kAdaptive}, anyChange,
      [](const AskedMoment& asked, const Scenario& scenario, const PlaneChange& change) {
        const AskedMoment there = change.asked(asked);
        const Scenario read = expectSameLineAndVerdict(change.scenario(scenario), there);
        if (scenario.answer.status.code != StatusCode::kOk) return;
        EXPECT_TRUE(testedReport(read.answer.trajectory, there).verified());
      });
}

TEST(AnswersReadBack, BagMessagesKeepTheVerdict) {
  forChangedAnswers(
      kBothModes, anyChange,
      [](const AskedMoment& asked, const Scenario& scenario, const PlaneChange& change) {
        if (scenario.answer.status.code != StatusCode::kOk) return;
        const AttackerTrajectory written = change.trajectory(scenario.answer.trajectory);
        expectSameVerdict(fromMessage(toMessage(written)), written, change.asked(asked));
      });
}

/// Expects that each frame of the clip after t0 is on the attacker's trajectory and on the ego's
/// recorded track.
void expectFramesOf(const CollideClip& read, const AttackerTrajectory& drive, const Track& ego) {
  for (std::size_t frame = kCollideNowFrame + 1; frame < read.times.size(); ++frame) {
    const auto missed = [&](const CollideTrack& track, const Pose2& expected) {
      const PatternMiss miss = missBetween(expected, track.frames[frame]->pose);
      return std::max(miss.distance, miss.heading);
    };
    EXPECT_LE(missed(read.attacker(), poseAt(drive, read.times[frame])), kSamePlace);
    EXPECT_LE(missed(read.ego(), stateAt(ego, read.times[frame])->pose), kSamePlace);
  }
}

TEST(AnswersReadBack, ClipsKeepRowsOutcomeAndMotion) {
  const TemporaryFolder folder;
  const auto check = [&](const AskedMoment& asked, const Scenario& scenario,
                         const PlaneChange& change) {
    if (scenario.answer.status.code != StatusCode::kOk) return;
    const AskedMoment there = change.asked(asked);
    const Scenario moved = change.scenario(scenario);
    const auto made = toCollideClip(moved, there.recording->scene, 0);
    const auto* clip = std::get_if<CollideClip>(&made);
    if (clip == nullptr) return;
    const std::string path = folder.path() + "/" + clip->name + ".csv";
    const std::string again = folder.path() + "/again.csv";
    writeCollideClip(path, *clip);
    const CollideClip read = readCollideClip(path, embeddedConfig().input_limits);
    writeCollideClip(again, read);
    EXPECT_EQ(contentOf(again), contentOf(path));
    expectFramesOf(read, moved.answer.trajectory, there.recording->scene.ego);
    const PublishedOutcome before = outcomeOf(*clip), after = outcomeOf(read);
    EXPECT_EQ(after.event, before.event);
    EXPECT_EQ(after.step, before.step);
    EXPECT_EQ(after.similar, before.similar);
  };
  forChangedAnswers(kBothModes, anyChange, check);
}

/// Returns a random finite number, sometimes the largest or the smallest.
double anyNumber(Random& random) {
  if (isLikely(random, 0.1)) return std::numeric_limits<double>::max();
  if (isLikely(random, 0.1)) return std::numeric_limits<double>::denorm_min();
  return random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-12.0, 12.0));
}

TEST(AnswersReadBack, RequestLinesRoundTrip) {
  forAllCases([](Random& random) {
    SceneRequest asked{"scene-\"\\\n0001", anyNumber(random), {}};
    CollisionRequest& request = asked.request;
    request.type = oneOf(kAllCollisionTypes, random);
    request.tta = anyNumber(random);
    request.seed = std::numeric_limits<std::uint64_t>::max() - random.index(1000);
    request.crash.believable = isLikely(random, 0.5);
    if (isLikely(random, 0.5)) request.attacker = "\t\xc3\xa4 \"";
    if (isLikely(random, 0.5)) request.attacker_class = oneOf(kAttackerClasses, random);
    if (isLikely(random, 0.5)) request.manoeuvre = oneOf(kManoeuvres, random);
    if (isLikely(random, 0.5)) request.impact_speed = Range{anyNumber(random), anyNumber(random)};
    if (isLikely(random, 0.5)) request.overlap = Range{anyNumber(random), anyNumber(random)};
    if (isLikely(random, 0.5)) request.turning = Turning::kEgo;
    if (isLikely(random, 0.5)) request.from_side = Side::kRight;
    if (isLikely(random, 0.5)) request.hidden_by = Hider::kParkedVehicle;
    for (const RangeControl& control : kRangeControls) {
      if (isLikely(random, 0.3)) {
        request.*control.asked = Range{anyNumber(random), anyNumber(random)};
      }
    }
    const SceneRequest read = readRequestLine("here", requestLine(asked));
    EXPECT_EQ(requestLine(read), requestLine(asked));
    EXPECT_EQ(read.now, asked.now);
    EXPECT_EQ(read.request.tta, request.tta);
    EXPECT_EQ(read.request.seed, request.seed);
    EXPECT_EQ(read.request.attacker, request.attacker);
  });
}

}  // namespace
}  // namespace forge
