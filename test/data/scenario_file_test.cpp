#include "collision_forge/data/scenario_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "data/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kNow = 1531883530.949817;  // s

Scenario attack() {
  Scenario scenario;
  scenario.asked = {"scene-0001", kNow, {CollisionType::kRearEnd, 4.0, "a1", Mode::kReplay, 7, {}}};
  scenario.ego = {{4.084, 1.73}, 1.385};
  Realization& answer = scenario.answer;
  answer.aim = {CollisionType::kRearEnd, "a1", kNow + 4.0, {{40.0, 1.0, 0.5}, {4.084, 1.73}},
                {-4.3, 0.25, 0.125},     12.5};
  answer.miss = {0.25, 0.0625};
  answer.trajectory = {"a1", AgentClass::kCar, {4.6, 1.9}, {}};
  answer.trajectory.points = {{kNow, {1.0, 2.0, 0.25}, 9.0, 0.5, 0.01},
                              {kNow + 0.1, {1.9, 2.0, 0.3}, 9.05, -0.5, -0.02}};
  CollisionReport& report = answer.report;
  report.contact = report.type_kept = report.on_time = report.limits_kept = true;
  report.contact_time = kNow + 3.875;
  report.relative_heading = 0.0625;
  report.ego_at_contact = {39.0, 1.0, 0.5};
  report.attacker_at_contact = {34.5, 1.25, 0.5625};
  report.impact_speed = 4.5;
  report.off_road_share = 0.75;
  report.confidence = 0.6;
  return scenario;
}

// Derived by hand from attack() and docs/scenarios.md.
const char* const kAttackLine =
    R"({"format":"collision_forge/scenario","version":2,"scene":"scene-0001","now":1531883530.949817,)"
    R"("request":{"type":"rear_end","tta":4,"attacker":"a1","mode":"replay","seed":7},)"
    R"("status":{"code":"OK","message":""},"attacker":{"id":"a1","length":4.6,"width":1.9,"trajectory":[)"
    R"({"t":0,"x":1,"y":2,"yaw":0.25,"v":9,"a":0.5,"kappa":0.01},)"
    R"({"t":0.1,"x":1.9,"y":2,"yaw":0.3,"v":9.05,"a":-0.5,"kappa":-0.02}]},)"
    R"("pattern":{"t":4,"ego":{"x":40,"y":1,"yaw":0.5},"attacker_offset":{"x":-4.3,"y":0.25,"yaw":0.125},)"
    R"("attacker_speed":12.5,"miss_distance":0.25,"miss_heading":0.0625},"confidence":0.6,"report":{"verified":true,"contact":true,"contact_t":3.875,)"
    R"("relative_heading":0.0625,"ego_at_contact":{"x":39,"y":1,"yaw":0.5},)"
    R"("attacker_at_contact":{"x":34.5,"y":1.25,"yaw":0.5625},"ego_side":"rear","attacker_side":"front",)"
    R"("impact_speed":4.5,"type_kept":true,)"
    R"("on_time":true,"limits_kept":true,"broken_limit":null,"first_other":null,"off_road_share":0.75},)"
    R"("ego":{"length":4.084,"width":1.73,"center_offset":1.385}})";

Scenario refusal() {
  Scenario scenario = attack();
  scenario.asked.request.attacker.reset();
  scenario.answer = {};
  scenario.answer.status = {StatusCode::kNoCandidate, "nobody \"near\""};
  return scenario;
}

std::string complaintAbout(std::string line, const std::string& from, const std::string& to) {
  replaceIn(line, from, to);
  try {
    readScenarioLine("file: line 9", line);
  } catch (const JsonLineError& error) {
    return error.what();
  }
  return "";
}

TEST(ScenarioFile, AnAttackHasTheDocumentedForm) { EXPECT_EQ(scenarioLine(attack()), kAttackLine); }

TEST(ScenarioFile, ARefusalHasNullsAndItsMessage) {
  EXPECT_THAT(
      scenarioLine(refusal()),
      AllOf(HasSubstr(R"("attacker":null,"mode")"),
            HasSubstr(
                R"("status":{"code":"NO_CANDIDATE","message":"nobody \"near\""},"attacker":null,)"
                R"("pattern":null,"confidence":null,"report":null,"ego":{)")));
}

TEST(ScenarioFile, LinesAreReadAsTheyWereWritten) {
  for (const Scenario& scenario : {attack(), refusal()}) {
    const std::string line = scenarioLine(scenario);
    EXPECT_EQ(scenarioLine(readScenarioLine("", line)), line);
  }
}

TEST(ScenarioFile, TimesAreReadOnTheScenesClock) {
  const Scenario read = readScenarioLine("", kAttackLine);
  constexpr double kRounding = 5e-7;  // s
  EXPECT_NEAR(read.answer.trajectory.points[1].time, kNow + 0.1, kRounding);
  EXPECT_NEAR(read.answer.aim.time, kNow + 4.0, kRounding);
  EXPECT_NEAR(read.answer.report.contact_time, kNow + 3.875, kRounding);
  EXPECT_EQ(read.answer.aim.ego.size.length, 4.084);
  EXPECT_EQ(read.answer.aim.attacker_id, "a1");
  EXPECT_EQ(read.answer.aim.type, CollisionType::kRearEnd);
  EXPECT_EQ(read.answer.miss.distance, 0.25);
  EXPECT_EQ(read.answer.miss.heading, 0.0625);
  EXPECT_EQ(read.answer.report.confidence, 0.6);
  EXPECT_TRUE(read.answer.report.verified());
}

TEST(ScenarioFile, MalformedLinesNameTheField) {
  const auto field = [](const std::string& name) {
    return AllOf(HasSubstr("file: line 9: field "), HasSubstr(name));
  };
  EXPECT_THAT(complaintAbout(kAttackLine, "forge/scenario", "forge/request"), field("format"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"version\":2", "\"version\":1"), field("version = 1"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"rear_end\"", "\"drift\""), field("request.type"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"replay\"", "\"live\""), field("request.mode"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"OK\"", "\"FINE\""), field("status.code"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"kappa\":-0.02", "\"kappa\":null"),
              field("attacker.trajectory[1].kappa"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"v\":9.05", "\"speed\":9.05"),
              field("attacker.trajectory[1].v is missing"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"center_offset\"", "\"extra\":1,\"center_offset\""),
              field("ego.extra"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"on_time\":true", "\"on_time\":false"),
              field("report.verified"));
  for (const std::string impossible : {"-4", "0", "1e999"}) {
    EXPECT_THAT(
        complaintAbout(kAttackLine, "\"length\":4.6", "\"length\":" + impossible),
        HasSubstr(impossible == "1e999" ? "file: line 9" : "attacker.length = " + impossible));
    EXPECT_THAT(
        complaintAbout(kAttackLine, "\"width\":1.9", "\"width\":" + impossible),
        HasSubstr(impossible == "1e999" ? "file: line 9" : "attacker.width = " + impossible));
  }
  EXPECT_THAT(complaintAbout(scenarioLine(refusal()), "\"confidence\":null", "\"confidence\":1"),
              field("confidence"));
  EXPECT_THAT(complaintAbout(scenarioLine(refusal()), "\"pattern\":null", "\"pattern\":{}"),
              field("pattern"));
}

TEST(ScenarioFile, NumbersThatAreNoneAreNotWritten) {
  Scenario scenario = attack();
  scenario.answer.trajectory.points[0].curvature = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scenarioLine(scenario), std::invalid_argument);
}

}  // namespace
}  // namespace forge
