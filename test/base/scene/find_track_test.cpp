#include "collision_forge/base/scene/find_track.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(FindTrack, ReturnsTheTrackOrNull) {
  const std::vector<Track> tracks = {{"a", AgentClass::kCar, {}, {}},
                                     {"b", AgentClass::kBus, {}, {}}};
  EXPECT_EQ(findTrack(tracks, "b"), &tracks[1]);
  EXPECT_EQ(findTrack(tracks, "c"), nullptr);
  EXPECT_EQ(findTrack({}, "a"), nullptr);
}

}  // namespace
}  // namespace forge
