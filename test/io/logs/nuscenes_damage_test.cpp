#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/logs/nuscenes_tables.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using ::testing::HasSubstr;

/// One change to one table, and the texts that the message must contain besides the file.
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
    {"shortArray",
     "sample_annotation",
     "[15.0, 50, 1]",
     "[15.0, 50]",
     {"token a1", "field translation is not an array of 3 numbers"}},
    {"nanBox",
     "sample_annotation",
     "[15.0, 50, 1]",
     "[NaN, 50, 1]",
     {"token a1", "field translation", "not finite: NaN"}},
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
    {"unknownInstance",
     "sample_annotation",
     R"("ped")",
     R"("pod")",
     {"token p1", "field instance_token 'pod' is not a row of instance.json"}},
    {"sampleTwice", "sample", R"("f1")", R"("f2")", {"token f2", "field token is a duplicate"}},
    {"sceneNameOfAPath",
     "scene",
     "scene-0002",
     "../evil",
     {"token s2", R"(field name "../evil" is not a valid file name: it contains '/')"}},
    {"locationOfAPath",
     "log",
     "left-town",
     "/etc/town",
     {"token log", R"(field location "/etc/town" is not a valid file name: it contains '/')"}},
    {"sceneNameTwice",
     "scene",
     "scene-0002",
     "scene-0001",
     {"token s2", "field name 'scene-0001' is also the name of another scene"}},
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
    {"trailingGarbage", "sample", "[", "[]]", {"invalid JSON at byte"}},
};

INSTANTIATE_TEST_SUITE_P(All, DamagedNuScenesTables, ::testing::ValuesIn(kDamages),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace forge
