#include "collision_forge/io/maps/junctions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/base/map/lane_links.h"
#include "collision_forge/io/maps/lane_shapes.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Lane laneAlong(const std::string& id, const std::vector<Vector2>& line,
               std::vector<std::string> outgoing = {}) {
  Lane lane;
  lane.id = id;
  lane.centerline = posesAlong(line, 1.0, 1000);
  lane.outgoing = std::move(outgoing);
  return lane;
}

std::vector<std::string> markedOf(std::vector<Lane> lanes) {
  linkMutually(lanes);
  markJunctions(lanes);
  std::vector<std::string> marked;
  for (const Lane& lane : lanes) {
    EXPECT_EQ(lane.is_connector, lane.is_intersection);
    if (lane.is_connector) marked.push_back(lane.id);
  }
  return marked;
}

TEST(Junctions, CrossingLanesAndTurnsBesideThemAreConnectors) {
  EXPECT_THAT(
      markedOf({laneAlong("in", {{-40, 0}, {-10, 0}}, {"straight", "right"}),
                laneAlong("straight", {{-10, 0}, {10, 0}}, {"out"}),
                laneAlong("right", {{-10, 0}, {0, -3}, {3, -10}}),
                laneAlong("out", {{10, 0}, {40, 0}}), laneAlong("across", {{0.3, -40}, {0.3, 40}}),
                laneAlong("merge", {{7, 10}, {8, 1}, {10, 0}}, {"out"})}),
      ElementsAre("straight", "right", "across", "merge"));
}

TEST(Junctions, LanesThatMeetRunBesideOrMergeGentlyAreNone) {
  EXPECT_THAT(
      markedOf({laneAlong("a", {{0, 0}, {40, 0}}, {"b"}), laneAlong("b", {{40, 0}, {80, 0}}),
                laneAlong("back", {{80, 0}, {0, 0}}), laneAlong("merging", {{0, -4}, {40, 1}})}),
      IsEmpty());
}

}  // namespace
}  // namespace forge
