#include "collision_forge/io/export/scenario_net_tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "io/export/inlined.h"

namespace forge {
namespace {

using testing::HasSubstr;

const std::vector<double> kTimes = {0.0, 0.1, 0.25, 0.3};  // s

/// States at rows, 10 m/s along x.
Track trackAt(const std::string& id, AgentClass agent_class, const BoxSize& size,
              const std::vector<std::size_t>& rows) {
  Track track{id, agent_class, size, {}};
  for (const std::size_t row : rows) {
    track.states.push_back({kTimes[row], {10.0 * kTimes[row], 4.0, 0.25}, {10.0, 0.0}});
  }
  return track;
}

std::string tracksOf(const std::vector<Track>& tracks) {
  std::map<AgentClass, double> heights;
  for (const Track& track : tracks) heights[track.agent_class] = 1.5;
  return inlined([&](PickleWriter& writer) { writeTracks(writer, {kTimes, tracks}, heights); });
}

TEST(ScenarioNetTracks, HaveARowATimeAndZerosWhereNobodyIsSeen) {
  EXPECT_THAT(tracksOf({trackAt("a1", AgentClass::kTruck, {8.0, 2.5}, {1, 2, 3})}),
              HasSubstr(R"("state":{"position":[[0,0,0],[1,4,0],[2.5,4,0],[3,4,0]],)"
                        R"("heading":[0,0.25,0.25,0.25],"velocity":[[0,0],[10,0],[10,0],[10,0]],)"
                        R"("length":[0,8,8,8],"width":[0,2.5,2.5,2.5],"height":[0,1.5,1.5,1.5],)"
                        R"("valid":[false,true,true,true]})"));
}

TEST(ScenarioNetTracks, OutOfSightForATimeAreZerosThere) {
  EXPECT_THAT(tracksOf({trackAt("b1", AgentClass::kPedestrian, {0.5, 0.75}, {0, 3})}),
              HasSubstr(R"("valid":[true,false,false,true])"));
}

TEST(ScenarioNetTracks, EveryClassHasATypeOfTheFormat) {
  for (const auto& [agent_class, size, type] :
       {std::tuple(AgentClass::kMotorcycle, BoxSize{2.0, 0.5}, "CYCLIST"),
        std::tuple(AgentClass::kBicycle, BoxSize{2.0, 0.5}, "CYCLIST"),
        std::tuple(AgentClass::kTruck, BoxSize{8.0, 2.5}, "VEHICLE"),
        std::tuple(AgentClass::kPedestrian, BoxSize{0.5, 0.75}, "PEDESTRIAN"),
        std::tuple(AgentClass::kAnimal, BoxSize{0.5, 0.25}, "OTHER"),
        std::tuple(AgentClass::kStaticObject, BoxSize{0.4, 0.4}, "TRAFFIC_CONE"),
        std::tuple(AgentClass::kStaticObject, BoxSize{2.5, 0.5}, "TRAFFIC_BARRIER"),
        std::tuple(AgentClass::kStaticObject, BoxSize{0.5, 2.5}, "TRAFFIC_BARRIER")}) {
    EXPECT_THAT(tracksOf({trackAt("b1", agent_class, size, {0, 3})}),
                HasSubstr(std::string(R"("metadata":{"type":")") + type + R"(","class":")" +
                          toString(agent_class) + R"(","object_id":"b1")"));
  }
}

TEST(ScenarioNetTracks, TheSummaryTellsWayAndRowsUpToTheFirstGap) {
  for (const auto& [rows, told] :
       {std::pair(std::vector<std::size_t>{0, 1, 3},
                  R"("moving_distance":3,"valid_length":3,"continuous_valid_length":2})"),
        std::pair(std::vector<std::size_t>{1, 2, 3},
                  R"("moving_distance":2,"valid_length":3,"continuous_valid_length":3})"),
        std::pair(std::vector<std::size_t>{3},
                  R"("moving_distance":0,"valid_length":1,"continuous_valid_length":1})")}) {
    const Track track = trackAt("b1", AgentClass::kPedestrian, {0.5, 0.75}, rows);
    EXPECT_THAT(inlined([&](PickleWriter& writer) {
                  writeObjectSummary(writer, {kTimes, {track}});
                }),
                HasSubstr(R"("b1":{"type":"PEDESTRIAN","object_id":"b1","track_length":4,)" +
                          std::string(told)));
  }
}

TEST(ScenarioNetTracks, NumbersAreCountedByTypeAndWhoDrivesAMetreMoves) {
  const TrackTable table{kTimes,
                         {trackAt("ego", AgentClass::kCar, {4.0, 2.0}, {0, 1, 2, 3}),
                          trackAt("b1", AgentClass::kPedestrian, {0.5, 0.75}, {0, 3}),
                          trackAt("a1", AgentClass::kTruck, {8.0, 2.5}, {2, 3})}};  // half a metre
  EXPECT_EQ(inlined([&](PickleWriter& writer) { writeObjectNumbers(writer, table); }),
            R"({"object_types":["VEHICLE","PEDESTRIAN"],)"
            R"("num_objects_each_type":{"PEDESTRIAN":1,"VEHICLE":2},"num_objects":3,)"
            R"("num_moving_objects_each_type":{"PEDESTRIAN":1,"VEHICLE":1},)"
            R"("num_moving_objects":2})");
}

}  // namespace
}  // namespace forge
