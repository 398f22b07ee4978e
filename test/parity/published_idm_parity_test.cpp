#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "base/scene/shipped_limits.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/study/evaluation/clip_attackers.h"
#include "collision_forge/study/evaluation/published.h"
#include "collision_forge/study/evaluation/published_planner.h"
#include "parity/parity_fixture.h"
#include "planner_test/planners/planner_scenes.h"
#include "study/settings/shipped_study.h"

// The clips are not in the repository: FORGE_COLLIDE_DIR names the folder of the data set
// (docs/protocols.md).
#define SKIP_WITHOUT_CLIPS(clips) \
  if ((clips).empty()) GTEST_SKIP() << "FORGE_COLLIDE_DIR names no clips of COLLIDE"

namespace forge {
namespace {

using rapidjson::Value;

constexpr double kTolerance = 1e-6;     // m and m/s
constexpr double kMapTolerance = 2e-6;  // m and m/s, over a whole clip
constexpr std::size_t kStepsApart = 5;  // between the states of driven_egos

/// The path of each clip by its file's name.
std::map<std::string, std::string> clipPaths() {
  std::map<std::string, std::string> paths;
  const char* folder = std::getenv("FORGE_COLLIDE_DIR");
  if (!folder || !std::filesystem::is_directory(folder)) return paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto& path = entry.path();
    if (path.extension() == ".csv") paths[path.filename().string()] = path.string();
  }
  return paths;
}

std::vector<PublishedIdmStep> driveOf(const CollideClip& clip) {
  return publishedIdmDrive(clip, shippedStudy().planners.published_idm,
                           shippedStudy().evaluation.published);
}

PublishedOutcome outcomeOf(const CollideClip& clip) {
  std::vector<Pose2> ego;
  for (const PublishedIdmStep& step : driveOf(clip)) ego.push_back(step.pose);
  return publishedOutcome(clip, recordedFrames(clip), ego, shippedStudy().evaluation.published);
}

TEST(PublishedIdmParity, StepsAreThePublishedOnes) {
  const ParityFixture fixture("idm_published.json");
  SKIP_WITHOUT(fixture);
  for (const Value* one : fixture.cases("steps")) {
    const Value& in = memberOf(*one, "in");
    const double speed =
        publishedIdmSpeed(shippedStudy().planners.published_idm, numberOf(in, "speed"),
                          numberOf(in, "lead_speed"), numberOf(in, "distance"));
    EXPECT_NEAR(speed, numberOf(memberOf(*one, "out"), "next_speed"), kTolerance)
        << numberOf(in, "speed") << " behind " << numberOf(in, "lead_speed") << " at "
        << numberOf(in, "distance");
  }
}

TEST(PublishedIdmParity, EgosOfClipsDriveAsPublished) {
  const ParityFixture fixture("idm_published.json");
  SKIP_WITHOUT(fixture);
  const auto paths = clipPaths();
  SKIP_WITHOUT_CLIPS(paths);
  for (const Value* one : fixture.cases("driven_egos")) {
    const std::string name = textOf(*one, "in");
    if (paths.count(name) == 0) continue;
    const CollideClip clip = readCollideClip(paths.at(name), shippedLimits());
    const auto driven = driveOf(clip);
    const Value& expected = memberOf(memberOf(*one, "out"), "ego_x_y_v_every_5_steps");
    ASSERT_EQ((driven.size() + kStepsApart - 1) / kStepsApart, expected.Size()) << name;
    for (rapidjson::SizeType i = 0; i < expected.Size(); ++i) {
      // The original sorts by time: where less than five steps passed between two frames, the last
      // of these steps comes after the next frame.
      const std::size_t frame = std::min<std::size_t>(i, clip.times.size() - 1);
      constexpr double kLastStep = 0.4;  // s after the frame before
      const bool is_swapped =
          i > 0 && frame == i && clip.times[i] - clip.times[i - 1] < kLastStep - 1e-9;
      const PublishedIdmStep& step = driven[kStepsApart * i - (is_swapped ? 1 : 0)];
      EXPECT_NEAR(step.pose.x, numberOf(expected[i][0]), kMapTolerance) << name << " " << i;
      EXPECT_NEAR(step.pose.y, numberOf(expected[i][1]), kMapTolerance) << name << " " << i;
      EXPECT_NEAR(step.speed, numberOf(expected[i][2]), kMapTolerance) << name << " " << i;
    }
  }
}

TEST(PublishedIdmParity, ClipsAreHitAsPublished) {
  const ParityFixture fixture("idm_published.json");
  SKIP_WITHOUT(fixture);
  const auto paths = clipPaths();
  SKIP_WITHOUT_CLIPS(paths);
  int compared = 0;
  for (const Value* one : fixture.cases("cases")) {
    const std::string name = textOf(*one, "in");
    if (paths.count(name) == 0) continue;
    const Value& expected = memberOf(*one, "out");  // by out_fields
    const PublishedOutcome outcome = outcomeOf(readCollideClip(paths.at(name), shippedLimits()));
    EXPECT_EQ(outcome.isHit(), numberOf(expected[0]) != 0.0) << name;
    if (outcome.isHit()) {
      EXPECT_EQ(outcome.step, static_cast<int>(numberOf(expected[4]))) << name;
    }
    ++compared;
  }
  RecordProperty("clips", compared);
}

}  // namespace
}  // namespace forge
