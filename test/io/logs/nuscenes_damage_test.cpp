#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/logs/nuscenes_tables.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using ::testing::HasSubstr;

/// One change to one table, and what the message must name besides the file.
struct Damage {
  std::string name;
  std::string table;
  std::string from;
  std::string to;
  std::vector<std::string> named;
};

void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }

class DamagedNuScenesTables : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedNuScenesTables, nameFileTokenAndField) {
  const TemporaryFolder folder;
  auto tables = tinyTables();
  replaceIn(tables[GetParam().table], GetParam().from, GetParam().to);
  writeTables(folder, tables);
  const std::string error = errorOf([&] {
    const NuScenesRoot root(folder.path(), "v1.0-tiny");
    for (const std::string& name : root.sceneNames()) root.readScene(name);
  });
  EXPECT_THAT(error, HasSubstr("v1.0-tiny/" + GetParam().table + ".json: "));
  for (const std::string& named : GetParam().named) EXPECT_THAT(error, HasSubstr(named));
}

const Damage kDamages[] = {
    {"noField",
     "sample",
     R"("timestamp": 1533000000500000, )",
     "",
     {"token f1", "field timestamp is missing"}},
    {"noToken", "sample", R"("token": "f0", )", "", {"row 1", "field token is missing"}},
    {"textForInteger",
     "sample",
     "1533000000500000",
     R"("soon")",
     {"token f1", "field timestamp is not an integer"}},
    {"fractionForInteger",
     "sample",
     "1533000000500000",
     "1533000000.5",
     {"token f1", "field timestamp is not an integer: 1533000000.5"}},
    {"numberForText", "scene", R"("scene-0002")", "2", {"token s2", "field name is not a string"}},
    {"nullForText", "log", R"("left-town")", "null", {"token log", "field location"}},
    {"objectForArray",
     "sample_annotation",
     "[15.0, 50, 1]",
     R"({"x": 15})",
     {"token a1", "field translation is not an array of 3 numbers"}},
    {"shortArray",
     "sample_annotation",
     "[15.0, 50, 1]",
     "[15.0, 50]",
     {"token a1", "field translation is not an array of 3 numbers"}},
    {"mixedArray",
     "sample_annotation",
     "[15.0, 50, 1]",
     R"([15.0, "50", 1])",
     {"token a1", "field translation is not an array of 3 numbers"}},
    {"nestedArray",
     "sample_annotation",
     "[15.0, 50, 1]",
     "[15.0, [50], 1]",
     {"token a1", "field translation is not an array of 3 numbers"}},
    {"nanBox",
     "sample_annotation",
     "[15.0, 50, 1]",
     "[NaN, 50, 1]",
     {"token a1", "field translation", "not finite: NaN"}},
    {"infiniteBox",
     "sample_annotation",
     "[15.0, 50, 1]",
     "[15.0, -Infinity, 1]",
     {"token a1", "field translation", "not finite: -Infinity"}},
    {"nanPose",
     "ego_pose",
     "[100, 204, 0]",
     "[100, NaN, 0]",
     {"token e1", "field translation", "not finite: NaN"}},
    {"zeroSize",
     "sample_annotation",
     "[0.6, 0.7, 1.8]",
     "[0.6, 0.0, 1.8]",
     {"token p1", "field size", "not positive"}},
    {"zeroRotation",
     "sample_annotation",
     "[0, 0, 0, 2]",
     "[0, 0, 0, 0]",
     {"token p1", "field rotation is all zero"}},
    {"unknownLog",
     "scene",
     R"("log_token": "log")",
     R"("log_token": "lag")",
     {"token s1", "field log_token 'lag' is no row of log.json"}},
    {"unknownScene",
     "sample",
     R"("scene_token": "s2")",
     R"("scene_token": "s3")",
     {"token g0", "field scene_token 's3' is no row of scene.json"}},
    {"unknownCategory",
     "instance",
     "c-ped",
     "c-pad",
     {"token ped", "field category_token 'c-pad' is no row of category.json"}},
    {"unknownInstance",
     "sample_annotation",
     R"("ped")",
     R"("pod")",
     {"token p1", "field instance_token 'pod' is no row of instance.json"}},
    {"unknownSample",
     "sample_annotation",
     R"("sample_token": "f2")",
     R"("sample_token": "f9")",
     {"token a2", "field sample_token 'f9' is no row of sample.json"}},
    {"unknownAttribute",
     "sample_annotation",
     R"(["moving"])",
     R"(["flying"])",
     {"token a0", "field attribute_tokens 'flying' is no row of attribute.json"}},
    {"unknownEgoPose",
     "sample_data",
     R"("e1")",
     R"("e9")",
     {"token d1", "field ego_pose_token 'e9' is no row of ego_pose.json"}},
    {"unknownMount",
     "sample_data",
     "camera-here",
     "camera-there",
     {"token x0", "field calibrated_sensor_token 'camera-there' is no row"}},
    {"unknownSensor",
     "calibrated_sensor",
     R"("sensor_token": "lidar")",
     R"("sensor_token": "l")",
     {"token lidar-here", "field sensor_token 'l' is no row of sensor.json"}},
    {"sampleTwice", "sample", R"("f1")", R"("f2")", {"token f2", "field token is there twice"}},
    {"annotationTwice",
     "sample_annotation",
     R"("p1")",
     R"("a0")",
     {"token a0", "field token is there twice"}},
    {"egoPoseTwice", "ego_pose", R"("e1")", R"("e0")", {"token e0", "field token is there twice"}},
    {"sceneNameOfAPath",
     "scene",
     "scene-0002",
     "../evil",
     {"token s2", R"(field name "../evil" cannot be the name of a file: it has a '/')"}},
    {"sceneNameOfAFolder",
     "scene",
     "scene-0002",
     "..",
     {"token s2", R"(field name ".." cannot be the name of a file)"}},
    {"locationOfAPath",
     "log",
     "left-town",
     "/etc/town",
     {"token log", R"(field location "/etc/town" cannot be the name of a file: it has a '/')"}},
    {"sceneNameTwice",
     "scene",
     "scene-0002",
     "scene-0001",
     {"token s2", "field name 'scene-0001' is another scene's too"}},
    {"instanceTwiceInSample",
     "sample_annotation",
     R"("sample_token": "f2")",
     R"("sample_token": "f1")",
     {"field instance_token", kHexToken, "twice in one sample"}},
    {"twoSamplesAtOnce",
     "sample",
     "1533000000500000",
     "1533000001000000",
     {"token", "field timestamp 1533000001000000"}},
    {"twoPosesAtOnce",
     "ego_pose",
     "1533000000500001",
     "1533000001000001",
     {"token", "field timestamp 1533000001000001"}},
    {"noLidar",
     "sample_data",
     R"("h0", "sample_token": "g0")",
     R"("h0", "sample_token": "f0")",
     {"no sweep of LIDAR_TOP", "scene-0002"}},
    {"noSample",
     "sample",
     R"("scene_token": "s2")",
     R"("scene_token": "s1")",
     {"no sample of scene-0002"}},
    {"object", "sample", "[", "{\"rows\": [", {"is not an array of rows"}},
    {"rowsAreNumbers", "sample", "[", "[7, ", {"is not an array of rows"}},
    {"trailingGarbage", "sample", "[", "[]]", {"invalid JSON at byte"}},
};

INSTANTIATE_TEST_SUITE_P(All, DamagedNuScenesTables, ::testing::ValuesIn(kDamages),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace forge
