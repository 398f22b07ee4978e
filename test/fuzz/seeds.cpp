#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/forecast/speed_model_fit.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/io/weights/speed_model_file.h"
#include "fuzz/embedded_seeds.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"
#include "io/collide/collide_fixture.h"
#include "io/logs/map_fixture.h"
#include "io/logs/nuscenes_fixture.h"
#include "io/maps/open_drive_fixture.h"
#include "io/maps/small_common_road.h"
#include "io/maps/small_lanelet2.h"

namespace forge {
namespace {

using Seeds = std::vector<std::string>;

/// Returns the content of the file that `write` creates at the given path.
std::string writtenBy(const std::function<void(const std::string& path)>& write) {
  const InputFolder folder;
  const std::string path = folder.path() + "/written";
  write(path);
  return bytesOf(path);
}

Seeds clipSeeds() {
  const CollideClip straight =
      straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
  CollideClip crossing =
      straightClip(CollisionType::kJunctionCrossing, 90.0, 9, 8.0, {8.0, -8.0, M_PI_2}, 8.0);
  crossing.tracks.push_back(standingClipTrack("parked", {20.0, 5.0, 0.5}, 9));
  crossing.tracks.back().frames[3].reset();
  Seeds seeds;
  for (const CollideClip& clip : {straight, crossing}) {
    const auto write = [&](const std::string& path) { writeCollideClip(path, clip); };
    seeds.push_back(composeCollideName(clip) + "\n" + writtenBy(write));
  }
  return seeds;
}

Seeds configSeeds() {
  Seeds seeds;
  const std::string folder = COLLISION_FORGE_SOURCE_DIR "/config";
  for (const char* part : {"", "study"}) {
    for (const std::string& file : ConfigFolder(folder).files(part)) {
      seeds.push_back(file.substr(0, file.rfind('.')) + "\n" + bytesOf(folder + "/" + file));
    }
  }
  std::sort(seeds.begin(), seeds.end());  // folders are in any order
  return seeds;
}

Seeds commonRoadSeeds() {
  SmallCommonRoad file("DEU_Town-1_1_T-1");
  file.lanelet("1", 0.0, 0.0,
               SmallCommonRoad::ref("successor", "2") + "<speedLimit>9</speedLimit>");
  file.lanelet("2", 20.0, 0.0, "<userBidirectional>vehicle</userBidirectional>");
  file.moving("11", "car", {0.0, 0.0}, 9.0, 0, 3).moving("12", "bus", {30.0, 0.0}, 5.0, 1, 4);
  file.add("<staticObstacle id='20'><type>unknown</type>" + std::string(SmallCommonRoad::kBox) +
           SmallCommonRoad::state("initialState", {5.0, 4.0, 0.1}, 0, 0.0) + "</staticObstacle>");
  return {file.problem({0.0, 0.0, 0.0}, 0).text()};
}

/// Writes two lanes of opposite direction and a parking area.
std::string twoLanelets(SmallLanelet2 osm) {
  const std::string left = osm.line({{49.0003, 8.0}, {49.0003, 8.003}});
  const std::string middle = osm.line({{49.0, 8.0}, {49.0, 8.003}});
  const std::string right = osm.line({{48.9997, 8.0}, {48.9997, 8.003}});
  osm.lanelet(left, middle, "road", SmallLanelet2::tag("one_way", "no"));
  osm.lanelet(middle, right, "road", SmallLanelet2::tag("speed_limit", "30 mph"));
  osm.relation(
      SmallLanelet2::member("outer", osm.line({{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}})),
      SmallLanelet2::tag("type", "multipolygon") + SmallLanelet2::tag("subtype", "parking"));
  return osm.text();
}

Seeds laneletSeeds() { return {twoLanelets(SmallLanelet2())}; }

Seeds mapSeeds() { return {tinyMap(), embeddedMap(), openDriveCrossing()}; }

Seeds numberSeeds() {
  return {"0",
          "-0.0",
          "1",
          "-12.5e3",
          "0.1",
          "1e308",
          "4.9e-324",
          "123456789012345678",
          "1E+2",
          "2.5E-7",
          "1.7976931348623157e308",
          "9007199254740993",
          "0." + std::string(348, '0') + "1",
          std::string(42, '7') + "e-336"};
}

CollisionRequest demandingRequest() {
  CollisionRequest request = believableRequestFor(CollisionType::kLaneChange, 3.5);
  request.attacker = "a1";
  request.choice = AttackerChoice::kExisting;
  request.attacker_class = AgentClass::kTruck;
  request.manoeuvre = Manoeuvre::kCutIn;
  request.ego_side = Side::kLeft;
  request.impact_speed = Range{1.0, 9.5};
  request.overlap = Range{0.25, 1.0};
  request.from_side = Side::kLeft;
  request.hidden_by = Hider::kParkedVehicle;
  request.queue = true;
  for (const RangeControl& control : kRangeControls) request.*control.asked = Range{0.25, 1.0};
  request.alternatives = 3;
  request.seed = 7;
  return request;
}

Seeds requestSeeds() {
  const auto line = [](const CollisionRequest& request) {
    return requestLine({"scene-0001", kNow, request}, shippedCrash()) + "\n";
  };
  return {line(believableRequestFor(CollisionType::kLtap)) + line(requestFor()),
          line(demandingRequest())};
}

Scenario answered() {
  Scenario scenario;
  scenario.asked = {"scene-0001", kNow, requestFor()};
  scenario.ego = {kEgoSize, 1.385};
  Attack& answer = scenario.answer;
  answer.pattern = {CollisionType::kRearEnd,      "attacker",          kNow + 2.0,
                    {{16.0, 0.0, 0.0}, kEgoSize}, {-4.3, 0.25, 0.125}, 12.5};
  answer.trajectory = straightDrive({-14.7, 0.0, 0.0}, 10.0, 2.0);
  CollisionReport& report = answer.report;
  report.contact = report.type_kept = report.on_time = report.limits_kept = true;
  report.contact_time = kNow + 1.875;
  report.impact_speed = 4.5;
  report.overlap = 0.375;
  report.confidence = 0.6;
  return scenario;
}

Seeds scenarioSeeds() {
  Scenario rejection = answered();
  rejection.asked.request = demandingRequest();
  rejection.answer = {};
  rejection.answer.status = {StatusCode::kNoCandidate, "nobody is behind the ego"};
  Scenario adaptive = answered();
  adaptive.asked.request.mode = Mode::kAdaptive;
  adaptive.plans = {firstPlan(adaptive.answer.trajectory, AttackerPhase::kAttacking)};
  Scenario added = answered();
  const Track past = pastTrack("attacker", kCarSize, {-14.7, 0.0, 0.0}, 10.0);
  added.answer.trajectory.past = past.states;
  return {scenarioLine(answered()), scenarioLine(rejection), scenarioLine(adaptive),
          scenarioLine(added)};
}

std::vector<SpeedProfileRow> steadyRows() {
  std::vector<SpeedProfileRow> rows;
  for (int scene = 0; scene < 24; ++scene) {
    for (int frame = 0; frame < 20; ++frame) {
      const double speed = scene % 3 == 0 ? 0.0 : 4.0 + 0.3 * scene + 0.1 * (frame * scene % 3);
      rows.push_back({"scene-" + std::to_string(scene), frame, speed, {}});
    }
  }
  return rows;
}

Seeds speedSeeds() {
  SpeedModelFitOptions options = configuration().speed_model_fit;
  options.centers = 3;
  options.profiles = 3;
  options.standing_profiles = 2;
  const SpeedModel model = fitSpeedModelWithFolds(SpeedSituations(steadyRows()), 2, options, 0);
  return {writtenBy([&](const std::string& path) { writeSpeedModel(model, path); })};
}

Seeds tableSeeds() { return {joined(tinyTables()), joined(embeddedTables())}; }

Seeds weightSeeds() {
  PatternWeights fold = randomWeights(1);
  fold.left_out_scenes = {"scene-0001"};
  return {
      writtenBy([&](const std::string& path) {
        writePatternWeights({randomWeights(), fold}, path);
      }),
      writtenBy([](const std::string& path) { writePatternWeights({randomWeights(2)}, path); })};
}

Seeds definitionSeeds() {
  const std::string rule(80, '=');
  const std::string cage =
      "Header header\nAnimal[] animals\nint16 WORD=3\nfloat32[2] size\nuint8[3] tag\n" + rule +
      "\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n" + rule +
      "\nMSG: zoo_msgs/Animal\nstring name\nfloat64[] limbs\nduration age\n";
  const std::string paths =
      "t header.stamp\ns header.frame_id\ns animals[].name\nn animals[].limbs[]\nn size[1]\ns "
      "tag\n";
  const auto number = [](std::uint32_t value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const std::string animal =
      number(3) + "cat" + number(1) + std::string(8, '\1') + std::string(8, '\2');
  const std::string bytes = number(1) + number(3) + number(4) + number(3) + "map" + number(2) +
                            animal + animal + std::string(8, '\3') + "abc";
  return {joined({{"definition", cage}, {"paths", paths}, {"bytes", bytes}})};
}

}  // namespace

const SeedMakers& seedMakers() {
  static const SeedMakers makers = {{"bags", bagSeeds},
                                    {"clips", clipSeeds},
                                    {"commonroad", commonRoadSeeds},
                                    {"config", configSeeds},
                                    {"definitions", definitionSeeds},
                                    {"lanelets", laneletSeeds},
                                    {"map", mapSeeds},
                                    {"clouds", cloudSeeds},
                                    {"messages", messageSeeds},
                                    {"numbers", numberSeeds},
                                    {"realize", realizeSeeds},
                                    {"requests", requestSeeds},
                                    {"runs", runSeeds},
                                    {"scenarios", scenarioSeeds},
                                    {"speeds", speedSeeds},
                                    {"tables", tableSeeds},
                                    {"weights", weightSeeds}};
  return makers;
}

}  // namespace forge
