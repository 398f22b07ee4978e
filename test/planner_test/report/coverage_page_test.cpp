#include "collision_forge/planner_test/report/coverage_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<CatalogueEntry> catalogue() {
  CatalogueEntry cut_in{"set/cut_in", "a car <cuts> in", "", "", {}, {}};
  CollisionRequest cell;
  cell.type = CollisionType::kLaneChange;
  for (const double speed : {1.0, 2.0, 3.0}) {
    cell.attacker_speed = Range{speed - 0.2, speed + 0.2};
    cut_in.cells.push_back({"set/cut_in speed=" + std::to_string(std::lround(speed)), cell});
  }
  CollisionRequest crossing;
  crossing.type = CollisionType::kJunctionCrossing;
  crossing.attacker_class = AgentClass::kChild;
  return {cut_in,
          {"set/doors", "a door opens", "", "doors do not open", {}, {}},
          {"other/x", "a child crosses", "", "", {}, {{"other/x", crossing}}}};
}

Scenario scenarioOf(const std::string& name, StatusCode code) {
  Scenario scenario;
  scenario.asked.name = name;
  scenario.answer.status.code = code;
  return scenario;
}

PlannerTestResult testOf(const std::string& name, bool is_hit, bool is_avoidable) {
  PlannerTestResult result;
  result.name = name;
  result.status = "OK";
  PlannerRow& row = result.rows.emplace_back();
  row.planner = "idm";
  if (is_hit) {
    row.outcome.contact.emplace();
    row.outcome.contact->is_attacker = true;
    row.evasion.emplace().is_avoidable = is_avoidable;
  }
  return result;
}

/// Returns the table row of a cell.
std::string rowOf(const std::string& page, const std::string& cell) {
  const std::size_t begin = page.find("<td>" + cell + "</td>");
  return begin == std::string::npos ? "" : page.substr(begin, page.find("</tr>", begin) - begin);
}

TEST(Coverage, CountsRequestsAttacksAndTestsByCell) {
  Coverage coverage(catalogue());
  coverage.add(scenarioOf("set/cut_in speed=1", StatusCode::kOk), "a:1");
  coverage.add(scenarioOf("set/cut_in speed=1", StatusCode::kOk), "a:2");
  coverage.add(scenarioOf("set/cut_in speed=1", StatusCode::kRoadDoesNotAllow), "a:3");
  coverage.add(scenarioOf("set/cut_in speed=2", StatusCode::kNoCandidate), "a:4");
  coverage.add(testOf("a:1", true, true));
  coverage.add(testOf("a:2", false, false));
  coverage.add(testOf("b:1", true, true));
  PlannerTestResult failed = testOf("a:1", false, false);
  failed.rows.front().outcome.failure = PlannerFailure::kEmpty;
  coverage.add(failed);
  const std::string page = coverage.page();
  EXPECT_THAT(page, AllOf(HasSubstr("set: 1 of 3 cells generated"), HasSubstr("a car &lt;cuts> in"),
                          HasSubstr("cannot be requested: doors do not open"),
                          Not(HasSubstr("a child crosses"))));
  EXPECT_THAT(
      rowOf(page, "cut_in speed=1"),
      HasSubstr("<td>3</td><td>2</td><td>2</td><td>0</td><td>1 (1) / 1</td><td class=\"reason\">1 "
                "ROAD_DOES_NOT_ALLOW</td>"));
  EXPECT_THAT(rowOf(page, "cut_in speed=2"),
              HasSubstr("<td>1</td><td>1</td><td>0</td><td>0</td><td></td>"));
  EXPECT_THAT(rowOf(page, "cut_in speed=3"), HasSubstr("no request"));
}

TEST(Coverage, CountsAttacksOfOtherRequestsInTheCellsThatTheyMeet) {
  Coverage coverage(catalogue());
  Scenario cut_in = scenarioOf("", StatusCode::kOk);
  cut_in.asked.request.type = CollisionType::kLaneChange;
  coverage.add(cut_in, "a:1");
  EXPECT_TRUE(coverage.empty()) << "its conditions are unknown";
  ContactConditions measured;
  measured.attacker_speed = 2.1;
  coverage.add(cut_in, "a:2", measured);
  cut_in.asked.request.attacker_speed = Range{0.0, 5.0};
  cut_in.answer.report.conditions.attacker_speed = 3.1;
  coverage.add(cut_in, "a:3");
  Scenario child = scenarioOf("", StatusCode::kOk);
  child.asked.request.type = CollisionType::kJunctionCrossing;
  child.answer.trajectory.agent_class = AgentClass::kChild;
  coverage.add(child, "a:4");
  child.answer.trajectory.agent_class = AgentClass::kPedestrian;
  coverage.add(child, "a:5");
  coverage.add(testOf("a:4", true, true));
  const std::string page = coverage.page();
  EXPECT_THAT(page, AllOf(HasSubstr("set: 2 of 3 cells generated"),
                          HasSubstr("other: 1 of 1 cell generated")));
  EXPECT_THAT(rowOf(page, "cut_in speed=1"), HasSubstr("<td>0</td><td>0</td><td>0</td><td>0</td>"));
  for (const char* cell : {"cut_in speed=2", "cut_in speed=3"}) {
    EXPECT_THAT(rowOf(page, cell), HasSubstr("<td>0</td><td>0</td><td>0</td><td>1</td>"));
  }
  EXPECT_THAT(rowOf(page, "x"),
              HasSubstr("<td>0</td><td>0</td><td>0</td><td>1</td><td>1 (1) / 0</td>"));
}

TEST(Coverage, IsEmptyWithoutARequestOfACatalogueAndAnAttackThatMeetsACell) {
  Coverage coverage(catalogue());
  Scenario scenario = scenarioOf("", StatusCode::kOk);
  scenario.asked.request.type = CollisionType::kRearEnd;
  coverage.add(scenario, "a:1");
  scenario.asked.request.type = CollisionType::kLaneChange;
  scenario.answer.status.code = StatusCode::kNoCandidate;
  coverage.add(scenario, "a:2");
  EXPECT_TRUE(coverage.empty());
}

}  // namespace
}  // namespace forge
