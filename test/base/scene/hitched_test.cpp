#include "collision_forge/base/scene/hitched.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

/// Drives along x, its middle at `x` first, 5 m further in each of three states.
Track driving(const char* id, AgentClass agent_class, double x, double y = 0.0) {
  Track track{id, agent_class, {8.0, 2.5}, {}};
  for (int i = 0; i < 3; ++i) {
    track.states.push_back({0.5 * i, {x + 5.0 * i, y, 0.0}, {10.0, 0.0}});
  }
  return track;
}

TEST(Hitched, ATruckHasTheTrailerBehindIt) {
  const std::vector<Track> agents = {driving("tractor", AgentClass::kTruck, 10.0),
                                     driving("trailer", AgentClass::kTrailer, -0.4),
                                     driving("next", AgentClass::kTruck, -10.8)};
  EXPECT_EQ(hitchedTo(agents[0], agents), &agents[1]);
  EXPECT_EQ(hitchedTo(agents[2], agents), nullptr) << "drives behind the trailer";
  EXPECT_EQ(hitchedTo(agents[1], agents), &agents[0]);
}

TEST(Hitched, ABusHasItsSecondHalf) {
  const std::vector<Track> agents = {driving("front", AgentClass::kBus, 10.0),
                                     driving("rear", AgentClass::kBus, 1.8)};
  EXPECT_NE(hitchedTo(agents[0], agents), nullptr);
}

TEST(Hitched, VehiclesInAQueueOrSideBySideAreNot) {
  const std::vector<Track> agents = {
      driving("truck", AgentClass::kTruck, 10.0), driving("behind", AgentClass::kTruck, 1.2),
      driving("beside", AgentClass::kTrailer, 10.0, 2.6), driving("car", AgentClass::kCar, 18.0)};
  EXPECT_EQ(hitchedTo(agents[0], agents), nullptr);
}

TEST(Hitched, VehiclesThatPartAreNot) {
  std::vector<Track> agents = {driving("tractor", AgentClass::kTruck, 10.0),
                               driving("trailer", AgentClass::kTrailer, 2.3)};
  agents[1].states.back().pose.x -= 4.0;
  EXPECT_EQ(hitchedTo(agents[0], agents), nullptr);
}

}  // namespace
}  // namespace forge
