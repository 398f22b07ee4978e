#include "collision_forge/planner_test/report/pictures.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "base/scene/shipped_limits.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::EndsWith;

/// A hit of idm; later ones are harder.
PlannerTestResult hit(int number) {
  PlannerTestResult result;
  result.name = "case:" + std::to_string(number);
  result.scene = "scene-" + std::to_string(number);
  result.status = "OK";
  PlannerRow row;
  row.planner = "idm";
  row.outcome.contact = PlannerContact();
  row.outcome.contact->is_attacker = true;
  row.outcome.contact->impact_speed = number;
  result.rows = {row};
  return result;
}

TEST(PicturesBeside, AreFoundByTheirRankAmongTheHits) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/worst");
  folder.write("worst/idm_fixed_1.gif", "");
  folder.write("worst/idm_fixed_1.png", "");
  folder.write("worst/idm_fixed_2.png", "");
  const auto pictures =
      picturesBeside(folder.path() + "/results.jsonl", {hit(1), hit(2), hit(3)}, shippedLimits());
  ASSERT_EQ(pictures.at({"case:3", "idm"}).size(), 1u);
  EXPECT_THAT(pictures.at({"case:3", "idm"})[0].path, EndsWith("worst/idm_fixed_1.gif"));
  EXPECT_THAT(pictures.at({"case:2", "idm"})[0].path, EndsWith("worst/idm_fixed_2.png"));
  EXPECT_TRUE(pictures.at({"case:1", "idm"}).empty());
}

TEST(PicturesBeside, DifferByBackground) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/worst");
  folder.write("worst/idm_fixed_1.png", "");
  folder.write("worst/idm_fixed_idm_1.png", "");
  PlannerTestResult both = hit(1);
  both.rows.push_back(both.rows.front());
  both.rows.back().background = Background::kIdm;
  const auto pictures = picturesBeside(folder.path() + "/results.jsonl", {both}, shippedLimits());
  EXPECT_THAT(pictures.at({"case:1", "idm"})[0].path, EndsWith("idm_fixed_1.png"));
  EXPECT_THAT(pictures.at({"case:1", "idm in idm traffic"})[0].path,
              EndsWith("idm_fixed_idm_1.png"));
}

TEST(PicturesBeside, AreSearchedOnlyBesideTheResults) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/out/worst");
  folder.write("secret_fixed_1.png", "");
  PlannerTestResult stranger = hit(1);
  stranger.rows.front().planner = "../../secret";
  EXPECT_TRUE(
      picturesBeside(folder.path() + "/out/results.jsonl", {stranger}, shippedLimits()).empty());
}

TEST(PicturesBeside, ShowHitAndEvasionOfAWeakness) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/weaknesses");
  folder.write("witnesses.jsonl",
               R"({"name":"case:1","planner":"idm","policy":"fixed","background":"replay"})");
  folder.write("weaknesses/1.gif", "");
  folder.write("weaknesses/1_escape.gif", "");
  const auto pictures = picturesBeside(folder.path() + "/results.jsonl", {hit(1)}, shippedLimits());
  ASSERT_EQ(pictures.at({"case:1", "idm"}).size(), 2u);
  EXPECT_THAT(pictures.at({"case:1", "idm"})[1].path, EndsWith("weaknesses/1_escape.gif"));
}

}  // namespace
}  // namespace forge
