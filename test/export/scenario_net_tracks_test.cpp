#include "collision_forge/export/scenario_net_tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "export/pickle_items.h"

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
  PickleWriter writer;
  std::map<AgentClass, double> heights;
  for (const Track& track : tracks) heights[track.agent_class] = 1.5;
  writeTracks(writer, {kTimes, tracks}, heights);
  return itemsOf(writer);
}

std::string summaryOf(const std::vector<Track>& tracks) {
  PickleWriter writer;
  writeObjectSummary(writer, {kTimes, tracks});
  return itemsOf(writer);
}

TEST(ScenarioNetTracks, HaveARowATimeAndZerosWhereNobodyIsSeen) {
  PickleWriter state;
  state.numbers("position", {0, 0, 0, 1, 4, 0, 2.5, 4, 0, 3, 4, 0}, 3);
  state.numbers("heading", {0, 0.25, 0.25, 0.25});
  state.numbers("velocity", {0, 0, 10, 0, 10, 0, 10, 0}, 2);
  state.numbers("length", {0, 8, 8, 8});
  state.numbers("width", {0, 2.5, 2.5, 2.5});
  state.numbers("height", {0, 1.5, 1.5, 1.5});
  state.flags("valid", {false, true, true, true});
  EXPECT_THAT(tracksOf({trackAt("a1", AgentClass::kTruck, {8.0, 2.5}, {1, 2, 3})}),
              HasSubstr(item(&PickleWriter::value, "state", state.dict())));
}

TEST(ScenarioNetTracks, OutOfSightForATimeAreZerosThere) {
  EXPECT_THAT(tracksOf({trackAt("b1", AgentClass::kPedestrian, {0.5, 0.75}, {0, 3})}),
              HasSubstr(item(&PickleWriter::flags, "valid", {true, false, false, true})));
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
                HasSubstr(textItem("type", type) + textItem("class", toString(agent_class)) +
                          textItem("object_id", "b1")));
  }
}

TEST(ScenarioNetTracks, TheSummaryTellsWayAndRowsUpToTheFirstGap) {
  for (const auto& [rows, distance, valid, continuous] :
       {std::tuple(std::vector<std::size_t>{0, 1, 3}, 3.0, 3u, 2u),
        std::tuple(std::vector<std::size_t>{1, 2, 3}, 2.0, 3u, 3u),
        std::tuple(std::vector<std::size_t>{3}, 0.0, 1u, 1u)}) {
    PickleWriter summary;
    summary.text("type", "PEDESTRIAN");
    summary.text("object_id", "b1");
    summary.count("track_length", 4);
    summary.number("moving_distance", distance);
    summary.count("valid_length", valid);
    summary.count("continuous_valid_length", continuous);
    EXPECT_THAT(summaryOf({trackAt("b1", AgentClass::kPedestrian, {0.5, 0.75}, rows)}),
                HasSubstr(item(&PickleWriter::value, "b1", summary.dict())));
  }
}

TEST(ScenarioNetTracks, NumbersAreCountedByTypeAndWhoDrivesAMetreMoves) {
  PickleWriter numbers;
  writeObjectNumbers(numbers,
                     {kTimes,
                      {trackAt("ego", AgentClass::kCar, {4.0, 2.0}, {0, 1, 2, 3}),
                       trackAt("b1", AgentClass::kPedestrian, {0.5, 0.75}, {0, 3}),
                       trackAt("a1", AgentClass::kTruck, {8.0, 2.5}, {2, 3})}});  // half a metre
  PickleWriter expected;
  expected.texts("object_types", {"VEHICLE", "PEDESTRIAN"});
  expected.beginDict("num_objects_each_type");
  expected.count("PEDESTRIAN", 1);
  expected.count("VEHICLE", 2);
  expected.endDict();
  expected.count("num_objects", 3);
  expected.beginDict("num_moving_objects_each_type");
  expected.count("PEDESTRIAN", 1);
  expected.count("VEHICLE", 1);
  expected.endDict();
  expected.count("num_moving_objects", 2);
  EXPECT_EQ(itemsOf(numbers), itemsOf(expected));
}

}  // namespace
}  // namespace forge
