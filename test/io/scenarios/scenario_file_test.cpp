#include "collision_forge/io/scenarios/scenario_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/scene/shipped_limits.h"
#include "base/scene/whole_attack.h"
#include "collision_forge/attack/search/request_check.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kNow = 1531883530.949817;  // s

Scenario attack() {
  Scenario scenario;
  scenario.asked.scene = "scene-0001";
  scenario.asked.now = kNow;
  CollisionRequest& request = scenario.asked.request;
  request.tta = 4.0;
  request.attacker = "a1";
  request.mode = Mode::kReplay;
  request.seed = 7;
  request.crash.believable = false;
  request.crash.limits = LimitSet::kStrict;
  request.attacker_class = AgentClass::kTruck;
  request.ego_side = Side::kRear;
  scenario.ego = {{4.084, 1.73}, 1.385};
  Attack& answer = scenario.answer;
  answer.pattern = {CollisionType::kRearEnd, "a1", kNow + 4.0, {{40.0, 1.0, 0.5}, {4.084, 1.73}},
                    {-4.3, 0.25, 0.125},     12.5, 1.5};
  answer.miss = {0.25, 0.0625};
  answer.trajectory = {"a1", AgentClass::kTruck, {4.6, 1.9}, {}};
  answer.trajectory.points = {{kNow, {1.0, 2.0, 0.25}, 9.0, 0.5, 0.01},
                              {kNow + 0.1, {1.9, 2.0, 0.3}, 9.05, -0.5, -0.02}};
  CollisionReport& report = answer.report;
  report.contact = report.type_kept = report.on_time = report.limits_kept = true;
  report.contact_time = kNow + 3.875;
  report.relative_heading = 0.0625;
  report.ego_at_contact = {39.0, 1.0, 0.5};
  report.attacker_at_contact = {34.5, 1.25, 0.5625};
  report.impact_speed = 4.5;
  report.overlap = 0.375;
  report.severity.ego = {2.5, 0.5, -0.25, 0.125, 0.0625, "A, rear", 1, 2};
  report.severity.other.delta_v = 1.5;
  report.severity.energy_lost = 4096.0;
  report.careful_drivers = {{"cc_driver", true, kNow + 2.5}, {"rss", false, {}}};
  report.off_road_share = 0.75;
  report.manoeuvre_begin = kNow + 1.5;
  report.road = {0.5, 0.25, 0.03, 0.125, 0.0625};
  report.unbelievable = "is on a walkway for 12 %";
  report.confidence = 0.6;
  answer.effort = 0.03125;
  return scenario;
}

// Derived by hand from attack() and docs/scenarios.md.
const char* const kAttackLine =
    R"({"format":"collision_forge/scenario","version":7,"scene":"scene-0001","now":1531883530.949817,)"
    R"("request":{"type":"rear_end","tta":4,"attacker":"a1","choice":"any","believable":false,)"
    R"("limits":"strict","attacker_class":"truck","manoeuvre":null,"ego_side":"rear","impact_speed":null,"overlap":null,"alternatives":1,)"
    R"("mode":"replay","seed":7},)"
    R"("status":{"code":"OK","message":""},"attacker":{"id":"a1","class":"truck","origin":"recorded",)"
    R"("length":4.6,"width":1.9,"past":null,"trajectory":[)"
    R"({"t":0,"x":1,"y":2,"yaw":0.25,"v":9,"a":0.5,"kappa":0.01},)"
    R"({"t":0.1,"x":1.9,"y":2,"yaw":0.3,"v":9.05,"a":-0.5,"kappa":-0.02}]},)"
    R"("pattern":{"t":4,"ego":{"x":40,"y":1,"yaw":0.5},"attacker_offset":{"x":-4.3,"y":0.25,"yaw":0.125},)"
    R"("attacker_speed":12.5,"tolerance":1.5,"miss_distance":0.25,"miss_heading":0.0625},)"
    R"("confidence":0.6,"effort":0.03125,"report":{"verified":true,"contact":true,"contact_t":3.875,)"
    R"("relative_heading":0.0625,"ego_at_contact":{"x":39,"y":1,"yaw":0.5},)"
    R"("attacker_at_contact":{"x":34.5,"y":1.25,"yaw":0.5625},"ego_side":"rear","attacker_side":"front",)"
    R"("impact_speed":4.5,"overlap":0.375,"severity":{"ego":{"delta_v":2.5,"force_from":0.5,"yaw_rate_change":-0.25,)"
    R"("mais2":0.125,"mais3":0.0625,"curve":"A, rear","least_class":1,"most_class":2},)"
    R"("other":{"delta_v":1.5,"force_from":0,"yaw_rate_change":0,"mais2":0,"mais3":0,"curve":"","least_class":0,"most_class":0},)"
    R"("energy_lost":4096},"careful_drivers":[{"driver":"cc_driver","avoids":true,"brakes_t":2.5},)"
    R"({"driver":"rss","avoids":false,"brakes_t":null}],"type_kept":true,)"
    R"("on_time":true,"limits_kept":true,"broken_limit":null,"first_other":null,"first_other_t":null,"off_road_share":0.75,"manoeuvre":"follower_closes",)"
    R"("manoeuvre_begin_t":1.5,"on_lane":0.5,"wrong_way":0.25,"off_road":0.03,"on_walkway":0.125,"on_island":0.0625,)"
    R"("believable":false,"unbelievable":"is on a walkway for 12 %"},"alternatives":[],"plans":[],)"
    R"("ego":{"length":4.084,"width":1.73,"center_offset":1.385}})";

/// An attack by an added vehicle, on a request with every constraint set.
Scenario addedAttack() {
  Scenario scenario = attack();
  CollisionRequest& request = scenario.asked.request;
  request.attacker.reset();
  request.choice = AttackerChoice::kNew;
  request.crash.believable = true;
  request.crash.limits = LimitSet::kDrivable;
  request.manoeuvre = Manoeuvre::kFollowerCloses;
  request.impact_speed = Range{3.0, 6.5};
  request.overlap = Range{0.25, 1.0};
  AttackerTrajectory& trajectory = scenario.answer.trajectory;
  const Pose2 before{-8.0, 2.0, 0.3};
  trajectory.past = {{kNow - 0.5, before, 9.1234567 * before.heading()},
                     {kNow, {1.0, 2.0, 0.25}, 9.0 * Pose2{0.0, 0.0, 0.25}.heading()}};
  scenario.answer.report.unbelievable.clear();
  return scenario;
}

/// The attacker braked after 0.5 s and was committed.
Scenario adaptiveAttack() {
  Scenario scenario = attack();
  scenario.asked.request.mode = Mode::kAdaptive;
  scenario.asked.request.crash.limits = LimitSet::kDrivable;
  const std::vector<TrajectoryPoint>& points = scenario.answer.trajectory.points;
  scenario.plans = {
      {kNow, kNow, AttackerPhase::kAttacking, "sets out", points},
      {kNow + 0.5, kNow + 0.8, AttackerPhase::kAttacking, "meets 94 %", {points.back()}},
      {kNow + 4.0, kNow + 4.3, AttackerPhase::kCommitted, "too late", {}}};
  return scenario;
}

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
    readScenarioLine("file: line 9", line, shippedLimits());
  } catch (const JsonLineError& error) {
    return error.what();
  }
  return "";
}

TEST(ScenarioFile, OnlyAdaptiveAttacksHavePlans) {
  const std::string line = scenarioLine(adaptiveAttack());
  EXPECT_THAT(complaintAbout(line, R"("mode":"adaptive")", R"("mode":"history")"),
              AllOf(HasSubstr("plans"), HasSubstr("line 9")));
  EXPECT_THAT(complaintAbout(line, R"("phase":"committed")", R"("phase":"asleep")"),
              HasSubstr("phase"));
  Scenario bare = adaptiveAttack();
  bare.plans.clear();
  EXPECT_THAT(complaintAbout(scenarioLine(bare), "", ""), HasSubstr("plans"));
}

TEST(ScenarioFile, AnAttackHasTheDocumentedForm) { EXPECT_EQ(scenarioLine(attack()), kAttackLine); }

TEST(ScenarioFile, ARejectionHasNullsAndItsMessage) {
  EXPECT_THAT(
      scenarioLine(refusal()),
      AllOf(
          HasSubstr(R"("attacker":null,"choice":"any")"),
          HasSubstr(
              R"("status":{"code":"NO_CANDIDATE","message":"nobody \"near\""},"attacker":null,)"
              R"("pattern":null,"confidence":null,"effort":null,"report":null,"alternatives":[],"plans":[],"ego":{)")));
}

TEST(ScenarioFile, RoundTripsAWholeAttack) {
  Scenario scenario = attack();
  scenario.asked.request.type = CollisionType::kLaneChange;
  scenario.asked.request.from_side = Side::kRight;
  scenario.answer = wholeAttack(kNow);
  scenario.answer.status.message = "a word on it";
  Attack another = wholeAttack(kNow);
  another.pattern.tolerance = 2.25;
  another.effort = 0.0625;
  scenario.answer.alternatives = {another};
  const Attack read = readScenarioLine("", scenarioLine(scenario), shippedLimits()).answer;
  expectSame(read, scenario.answer);
  ASSERT_EQ(read.alternatives.size(), 1u);
  expectSame(read.alternatives.front(), another);
}

TEST(ScenarioFile, HasMeasuredConditionsIfTheRequestHasOne) {
  Scenario scenario = attack();
  EXPECT_EQ(scenarioLine(scenario).find("conditions"), std::string::npos);
  scenario.asked.request.gap = Range{1.0, 20.0};
  EXPECT_NE(scenarioLine(scenario).find("conditions"), std::string::npos);
}

TEST(ScenarioFile, HasSupportsOnlyIfThereAreAny) {
  EXPECT_EQ(scenarioLine(attack()).find("supports"), std::string::npos);
  Scenario scenario = attack();
  scenario.answer = wholeAttack(kNow);
  std::string line = scenarioLine(scenario);
  replaceIn(line, "\"role\":\"queue\"", "\"role\":\"hedge\"");
  try {
    static_cast<void>(readScenarioLine("file", line, shippedLimits()));
    FAIL();
  } catch (const JsonLineError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("role"), HasSubstr("parked_vehicle")));
  }
}

TEST(ScenarioFile, HasTheNameInACatalogue) {
  Scenario scenario = attack();
  EXPECT_EQ(readScenarioLine("file", scenarioLine(scenario), shippedLimits()).asked.name, "");
  scenario.asked.name = "nhtsa/27_ltap_od_signalised turning=ego";
  EXPECT_EQ(readScenarioLine("file", scenarioLine(scenario), shippedLimits()).asked.name,
            scenario.asked.name);
}

TEST(ScenarioFile, EveryFieldOfAWholeAttackIsFilled) {
  const AttackFields filled = fieldsOf(wholeAttack(kNow));
  for (const auto& [name, value] : fieldsOf(Attack())) {
    if (name.rfind("status.", 0) == 0) continue;
    EXPECT_NE(filled.at(name), value) << name;
  }
}

/// Returns a line without the fields that version 6 does not have.
std::string asOfVersion6(std::string line) {
  const std::size_t begin = line.find(R"("severity":)");
  line.erase(begin, line.find(R"("type_kept")") - begin);
  replaceIn(line, R"("version":7)", R"("version":6)");
  return line;
}

/// The same for version 5.
std::string asOfVersion5(const std::string& line) {
  std::string older = asOfVersion6(line);
  for (const char* field : {R"("tolerance":1.5,)", R"("effort":0.03125,)",
                            R"("first_other_t":null,)", R"("off_road":0.03,)"}) {
    replaceIn(older, field, "");
  }
  replaceIn(older, R"("version":6)", R"("version":5)");
  return older;
}

Attack withoutSeverity() {
  Attack answer = attack().answer;
  answer.report.severity = {};
  answer.report.careful_drivers.clear();
  return answer;
}

TEST(ScenarioFile, AFileOfVersion6IsReadWithoutSeverity) {
  expectSame(readScenarioLine("", asOfVersion6(kAttackLine), shippedLimits()).answer,
             withoutSeverity());
}

TEST(ScenarioFile, AFileOfVersion5IsReadWithTheToleranceOfItsSearch) {
  const Attack read = readScenarioLine("", asOfVersion5(kAttackLine), shippedLimits()).answer;
  Attack expected = withoutSeverity();
  expected.pattern.tolerance = 4.0;
  expected.effort = 0.0;
  expected.report.road.off_road = 0.0;
  expectSame(read, expected);
}

TEST(ScenarioFile, RejectsAFieldOfALaterVersion) {
  for (const char* version : {"5", "6"}) {
    EXPECT_THAT(
        complaintAbout(kAttackLine, R"("version":7)", std::string(R"("version":)") + version),
        HasSubstr("file: line 9: field "));
  }
}

TEST(ScenarioFile, RejectsOlderVersions) {
  for (const char* old : {"1", "2", "3", "4"}) {
    EXPECT_THAT(complaintAbout(kAttackLine, "\"version\":7", std::string("\"version\":") + old),
                AllOf(HasSubstr(std::string("version = ") + old + " is not a version from 5 to 7"),
                      HasSubstr("generate the file again")));
  }
}

TEST(ScenarioFile, TimesAreReadOnTheScenesClock) {
  const Scenario read = readScenarioLine("", kAttackLine, shippedLimits());
  constexpr double kRounding = 5e-7;  // s
  EXPECT_NEAR(read.answer.trajectory.points[1].time, kNow + 0.1, kRounding);
  EXPECT_NEAR(read.answer.pattern.time, kNow + 4.0, kRounding);
  EXPECT_NEAR(read.answer.report.contact_time, kNow + 3.875, kRounding);
  EXPECT_EQ(read.answer.pattern.ego.size.length, 4.084);
  EXPECT_EQ(read.answer.pattern.attacker_id, "a1");
  EXPECT_EQ(read.answer.pattern.type, CollisionType::kRearEnd);
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
  EXPECT_THAT(
      complaintAbout(kAttackLine, "\"believable\":false,\"unb", "\"believable\":true,\"unb"),
      field("report.believable"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"follower_closes\"", "\"drifts\""),
              field("report.manoeuvre"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"mais3\":0.0625", "\"mais3\":1.5"),
              field("report.severity.ego.mais3"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"most_class\":2", "\"most_class\":4"),
              field("report.severity.ego.most_class"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"brakes_t\":2.5", "\"brakes_t\":1e300"),
              field("report.careful_drivers[0].brakes_t"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"driver\":\"rss\"", "\"driver\":\"ann\""),
              field("report.careful_drivers[1].driver"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"class\":\"truck\"", "\"class\":\"van\""),
              field("attacker.class"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"recorded\"", "\"found\""), field("attacker.origin"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"recorded\"", "\"added\""),
              AllOf(field("attacker.past"), HasSubstr("added")));
  EXPECT_THAT(complaintAbout(scenarioLine(addedAttack()), "\"added\"", "\"recorded\""),
              field("attacker.past"));
  EXPECT_THAT(complaintAbout(kAttackLine, "\"choice\":\"any\",", ""),
              field("request.choice is missing"));
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

TEST(ScenarioFile, NumbersBeyondTheLimitsNameFieldValueAndLimit) {
  const std::string added = scenarioLine(addedAttack());
  const struct {
    std::string from, to, problem;
  } cases[] = {
      {"\"length\":4.6", "\"length\":1e7", "attacker.length = 10000000.0 is outside 0.1 to 50"},
      {"\"width\":1.9", "\"width\":0.01", "attacker.width = 0.01 is outside 0.1 to 50"},
      {"\"x\":1.9", "\"x\":1e9",
       "attacker.trajectory[1].x = 1000000000.0 is outside -100000 to 100000"},
      {"\"t\":0.1,", "\"t\":1e9,",
       "attacker.trajectory[1].t = 1000000000.0 is outside -3600 to 60"},
      {"\"t\":0.1,", "\"t\":0,", "attacker.trajectory[1].t = 0 is not after the previous time"},
      {"\"v\":9.05", "\"v\":1e3", "attacker.trajectory[1].v = 1000.0 is outside -150 to 150"},
      {"{\"x\":40,", "{\"x\":-4e5,", "pattern.ego.x = -400000.0 is outside"},
      {"\"tolerance\":1.5", "\"tolerance\":-1", "pattern.tolerance = -1 is outside 0 to"},
      {"\"attacker_speed\":12.5", "\"attacker_speed\":1e300", "pattern.attacker_speed = 1e300"},
      {"\"contact_t\":3.875", "\"contact_t\":1e300", "report.contact_t = 1e300 is outside"},
      {"\"now\":1531883530.949817", "\"now\":1e300", "now = 1e300 is outside 0 to 4.29497e+09"},
      {"{\"length\":4.084", "{\"length\":1e9", "ego.length = 1000000000.0 is outside 0.1 to 50"},
      {"\"center_offset\":1.385", "\"center_offset\":1e9", "ego.center_offset = 1000000000.0"}};
  for (const auto& one : cases) {
    EXPECT_THAT(complaintAbout(kAttackLine, one.from, one.to),
                HasSubstr("file: line 9: field " + one.problem));
  }
  EXPECT_THAT(complaintAbout(added, "\"past\":[{\"t\":-0.5", "\"past\":[{\"t\":-1e5"),
              HasSubstr("attacker.past[0].t = -100000.0 is outside -3600 to 60"));
}

TEST(ScenarioFile, TrajectoriesHaveFromOnePointToTheLimit) {
  Scenario scenario = attack();
  std::vector<TrajectoryPoint>& points = scenario.answer.trajectory.points;
  points.clear();
  EXPECT_THAT(complaintAbout(scenarioLine(scenario), "", ""),
              HasSubstr("trajectory = [...] is empty"));
  for (int i = 0; i <= shippedLimits().max_points; ++i) points.push_back({kNow + 0.001 * i, {}});
  EXPECT_THAT(complaintAbout(scenarioLine(scenario), "", ""),
              HasSubstr("attacker.trajectory = [...] has 5001 elements, more than 5000"));
  points.pop_back();
  EXPECT_EQ(complaintAbout(scenarioLine(scenario), "", ""), "");
}

/// The largest number of alternatives, by vehicles with the longest allowed past.
TEST(ScenarioFile, TheLineLimitAllowsAllAlternativesWithTheirPasts) {
  Scenario scenario = addedAttack();
  AttackerTrajectory& trajectory = scenario.answer.trajectory;
  const int max_points = shippedLimits().max_points;
  trajectory.past.clear();
  for (int i = max_points; i > 0; --i) {
    const Pose2 pose{30000.0 / 7.0 + i, 40000.0 / 7.0, 1.0 / 3.0};
    trajectory.past.push_back({kNow - 0.1 * i, pose, 9.123456 * pose.heading()});
  }
  scenario.asked.request.alternatives = kMaxAlternatives;
  scenario.answer.alternatives.assign(kMaxAlternatives - 1, scenario.answer);
  const std::string line = scenarioLine(scenario);
  EXPECT_NO_THROW(readScenarioLine("here", line, shippedLimits()));
}

}  // namespace
}  // namespace forge
