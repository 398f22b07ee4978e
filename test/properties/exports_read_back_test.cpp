// Crashes in the formats of other tools are read back equal to the crash that was written.
#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>
#include <string>

#include "collision_forge/io/export/export_formats.h"
#include "collision_forge/io/logs/scenario_net_logs.h"
#include "collision_forge/io/maps/common_road_logs.h"
#include "io/logs/nuscenes_fixture.h"
#include "properties/plane_change.h"
#include "properties/same_verdict.h"

namespace forge {
namespace {

void move(Track& track, double later) {
  for (AgentState& state : track.states) state.time += later;
}

ReadCrash readOfScenarioNet(const std::string& path, const CrashRecord& written) {
  const Config& config = embeddedConfig();
  static PickleWorkers workers;
  const Scene scene = flattened(readScenarioNet(path, workers, config), {{}, config, {}, {}}).scene;
  ReadCrash read{scene.ego,
                 *std::find_if(scene.agents.begin(), scene.agents.end(), [&](const Track& agent) {
                   return agent.id == written.attacker.id;
                 })};
  const double begin = scene.ego.states.front().time;
  move(read.ego, -begin);
  move(read.attacker, -begin);
  return read;
}

std::vector<Vector2> pointsOf(const std::vector<Pose2>& poses) {
  std::vector<Vector2> points;
  for (const Pose2& pose : poses) points.push_back(pose.position());
  return points;
}

/// Returns false for a lane without two poses that are more than 1 mm apart.
bool isExported(const Lane& lane) {
  return std::any_of(lane.centerline.begin(), lane.centerline.end(), [&](const Pose2& pose) {
    return (pose.position() - lane.centerline.front().position()).norm() > 1e-3;
  });
}

/// Expects that every exported lane is read back, with its links and, to 1 cm, its centreline.
void expectSameLanes(const LaneMap& read, const LaneMap& written) {
  std::vector<const Lane*> exported;
  for (const Lane& lane : written.lanes) {
    if (isExported(lane)) exported.push_back(&lane);
  }
  EXPECT_EQ(read.driving_side, written.driving_side);
  ASSERT_EQ(read.lanes.size(), exported.size());
  for (std::size_t i = 0; i < exported.size(); ++i) {
    const Lane& lane = read.lanes[i];
    const Polyline line(pointsOf(exported[i]->centerline));
    for (const Pose2& pose : lane.centerline) {
      EXPECT_LT(line.project(pose.position()).distance, 0.01) << exported[i]->id;
    }
    EXPECT_LT((lane.centerline.back().position() - line.points().back()).norm(), 0.01);
    EXPECT_LT((lane.centerline.front().position() - line.points().front()).norm(), 0.01);
    EXPECT_EQ(lane.is_connector, exported[i]->is_connector || exported[i]->is_intersection);
  }
}

pugi::xml_document documentAt(const std::string& path) {
  pugi::xml_document document;
  if (!document.load_file(path.c_str())) throw std::runtime_error(path + ": is no XML");
  return document;
}

ReadCrash readOfCommonRoad(const std::string& path, const CrashRecord& written) {
  const Config& config = embeddedConfig();
  const Scene scene =
      flattened(readCommonRoadScenario(path, "1", config), {{}, config, {}, {}}).scene;
  ReadCrash read{scene.ego, *std::find_if(scene.agents.begin(), scene.agents.end(),
                                          [](const Track& agent) { return agent.id == "2"; })};
  const double begin = scene.ego.states.front().time;
  move(read.ego, -begin);
  move(read.attacker, -begin);
  expectSameLanes(*scene.map, written.lanes);
  return read;
}

/// Adds the states of a standing agent: the file has only the first and the last one of the stop.
void addStates(Track& track, const AgentState& until, double step) {
  while (!track.states.empty() && until.time - track.states.back().time > 1.5 * step) {
    track.states.push_back(track.states.back());
    track.states.back().time += step;
  }
  track.states.push_back(until);
}

Track trackOfOpenScenario(const pugi::xml_node& root, const std::string& name, double step) {
  const auto parameter = [&](const char* of) {
    return root.child("ParameterDeclarations")
        .find_child_by_attribute("ParameterDeclaration", "name", of)
        .attribute("value")
        .as_double();
  };
  const pugi::xml_node box = root.child("Entities")
                                 .find_child_by_attribute("ScenarioObject", "name", name.c_str())
                                 .child("Vehicle")
                                 .child("BoundingBox");
  const pugi::xml_node size = box.child("Dimensions");
  Track track{name,
              AgentClass::kCar,
              {size.attribute("length").as_double(), size.attribute("width").as_double()},
              {}};
  const double ahead = box.child("Center").attribute("x").as_double();
  const std::string path = "//Trajectory[@name='trajectory of " + name + "']/Shape/Polyline/Vertex";
  for (const pugi::xpath_node& vertex : root.select_nodes(path.c_str())) {
    const pugi::xml_node at = vertex.node().child("Position").child("WorldPosition");
    const Pose2 axle{at.attribute("x").as_double() + parameter("map_origin_x"),
                     at.attribute("y").as_double() + parameter("map_origin_y"),
                     at.attribute("h").as_double()};
    const double time = vertex.node().attribute("time").as_double();
    addStates(track, {time, compose(axle, {ahead, 0.0, 0.0})}, step);
  }
  return track;
}

ReadCrash readOfOpenScenario(const std::string& path, const CrashRecord& written) {
  const pugi::xml_document document = documentAt(path);
  const pugi::xml_node root = document.child("OpenSCENARIO");
  return {trackOfOpenScenario(root, "ego", written.step),
          trackOfOpenScenario(root, "attacker", written.step)};
}

/// A format with its writer, and with the reader of this test.
struct Format {
  const char* name;
  ReadCrash (*read)(const std::string& path, const CrashRecord& written);
};
constexpr Format kFormats[] = {{"scenarionet", readOfScenarioNet},
                               {"commonroad", readOfCommonRoad},
                               {"openscenario", readOfOpenScenario}};

TEST(ExportsReadBack, EveryFormatHasTheWrittenCrash) {
  ASSERT_EQ(std::size(kFormats) + 1, exportFormats().size());  // openlabel has no motions
  const TemporaryFolder folder;
  const Config& config = embeddedConfig();
  const ExportPlan plan{folder.path(), false, config.exports, config.attack.verification.drivable};
  const LaneArcs no_arcs;
  const auto check = [&](const AskedMoment& asked, const Scenario& scenario,
                         const PlaneChange& change) {
    if (scenario.answer.status.code != StatusCode::kOk) return;
    const AskedMoment there = change.asked(asked);
    const CrashRecord record =
        crashRecord(change.scenario(scenario), 1, config.exports.history,
                    {*there.recording, no_arcs, config.exports, config.attack.verification});
    for (const Format& format : kFormats) {
      SCOPED_TRACE(format.name);
      const std::string file = makeCrashWriter(format.name, plan)->write(record).back();
      expectSameCrash(format.read(folder.path() + "/" + file, record), record, there);
    }
  };
  forChangedAnswers(kAllModes, elsewhere, check);
}

}  // namespace
}  // namespace forge
