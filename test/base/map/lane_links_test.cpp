#include "collision_forge/base/map/lane_links.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Lane laneWith(const std::string& id, std::vector<std::string> incoming,
              std::vector<std::string> outgoing) {
  Lane lane;
  lane.id = id;
  lane.incoming = std::move(incoming);
  lane.outgoing = std::move(outgoing);
  return lane;
}

TEST(LaneLinks, ALinkInEitherLaneIsInBothOnce) {
  std::vector<Lane> lanes = {laneWith("a", {}, {"b", "b"}), laneWith("b", {"a"}, {}),
                             laneWith("c", {"b"}, {})};
  linkMutually(lanes);
  EXPECT_THAT(lanes[0].outgoing, ElementsAre("b"));
  EXPECT_THAT(lanes[1].incoming, ElementsAre("a"));
  EXPECT_THAT(lanes[1].outgoing, ElementsAre("c"));
}

TEST(LaneLinks, LinksToOtherLanesAreDropped) {
  std::vector<Lane> lanes = {laneWith("a", {"x"}, {"y"})};
  linkMutually(lanes);
  EXPECT_THAT(lanes[0].incoming, IsEmpty());
  EXPECT_THAT(lanes[0].outgoing, IsEmpty());
}

}  // namespace
}  // namespace forge
