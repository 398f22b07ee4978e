#include "collision_forge/planner_test/report/scene_record.h"

#include <gmock/gmock.h>

#include "collision_forge/io/json/json_line.h"
#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::Not;

const ReportOptions kOptions{1.0, 50.0, 0.1};

SceneExtent extentFromNow() {
  SceneExtent extent;
  extent.include(kNow, kNow + 2.0, rearEnd().answer.trajectory.points);
  return extent;
}

Track standing(const std::string& id, double x) {
  Track track;
  track.id = id;
  track.size = {4.0, 2.0};
  for (int i = -4; i <= 12; ++i) track.states.push_back({kNow + 0.5 * i, {x, 5.0, 0.0}, {0, 0}});
  return track;
}

TEST(SceneRecord, LeavesOutAgentsFarAway) {
  Scene scene = straightScene();
  scene.agents = {standing("near", 60.0), standing("far", 200.0)};
  const std::string record = sceneRecord(scene, extentFromNow(), kOptions);
  EXPECT_THAT(record, HasSubstr(R"("id":"near")"));
  EXPECT_THAT(record, Not(HasSubstr(R"("id":"far")")));
}

TEST(SceneRecord, ClipsTheRoadAtTheMargin) {
  // The attacker ends at 34 m and the ego starts at 0; with the margin, -50 to 84 m is kept.
  const std::string record = sceneRecord(straightScene(), extentFromNow(), kOptions);
  EXPECT_THAT(record, HasSubstr(R"("drivable":[{"rings":[)"));
  EXPECT_THAT(record, Not(HasSubstr("1e+06")));
}

}  // namespace
}  // namespace forge
