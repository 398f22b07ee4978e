#include "collision_forge/io/drawing/caption_text.h"

#include <gtest/gtest.h>

#include "io/drawing/sample_view.h"

namespace forge {
namespace {

/// Returns the row of that name; an empty row if there is none.
CaptionRow rowOf(const ScenarioView& view, const std::string& name) {
  for (const CaptionRow& row : reportRows(view)) {
    if (row.name == name) return row;
  }
  return {};
}

TEST(CaptionText, NamesTheAttackersClassAndOrigin) {
  ScenarioView view = sampleView();
  view.trajectory.agent_class = AgentClass::kConstructionVehicle;
  EXPECT_NE(detailsText(view).find("by a recorded construction vehicle, veh"), std::string::npos);
  view.trajectory.past = view.snapshot.agents.front().states;
  EXPECT_NE(detailsText(view).find("by an added construction vehicle"), std::string::npos);
}

TEST(CaptionText, TheVerdictNamesTheFirstFailedCondition) {
  ScenarioView view = sampleView();
  EXPECT_EQ(verdictText(view), "requested crash in the recording");
  EXPECT_EQ(verdictOf(view), Verdict::kWanted);
  const auto reason = [&view] {
    return verdictText(view).substr(verdictText(view).find(": ") + 2);
  };
  view.report.first_other_id = "truck-of-a-long-name";
  EXPECT_EQ(reason(), "hits truck- first");
  view.report.limits_kept = false;
  EXPECT_EQ(reason(), "a limit broken");
  view.report.on_time = false;
  EXPECT_EQ(reason(), "another time");
  view.report.type_kept = false;
  EXPECT_EQ(reason(), "another type");
  EXPECT_EQ(verdictText(view).find("other contact in the recording"), 0U);
  EXPECT_EQ(verdictOf(view), Verdict::kPartial);
  view.report.contact = false;
  EXPECT_EQ(verdictText(view), "no contact in the recording");
  EXPECT_EQ(verdictOf(view), Verdict::kUnwanted);
  view.pattern.time = view.future.ego.states.back().time + 0.1;
  EXPECT_EQ(verdictText(view), "the recording ends before the contact");
}

TEST(CaptionText, APlannerTestNamesThePlannerAndTheHit) {
  ScenarioView view = sampleView();
  view.planner = "pdm against adaptive";
  EXPECT_EQ(titleText(view), "pdm against adaptive: Rear end in scene-0001");
  EXPECT_EQ(verdictText(view), "hit by the attacker");
  EXPECT_EQ(verdictOf(view), Verdict::kUnwanted);
  EXPECT_EQ(rowOf(view, "Contact").passed, false);
}

TEST(CaptionText, AnAvoidedHitHasNoContactAndIsWanted) {
  ScenarioView view = sampleView();
  view.planner = "pdm";
  view.report.contact = false;
  view.avoided_hit = view.snapshot.now + 3.25;
  EXPECT_EQ(verdictText(view), "avoids the hit");
  EXPECT_EQ(verdictOf(view), Verdict::kWanted);
  EXPECT_EQ(rowOf(view, "Contact").value, "none (hit: +3.25 s)");
  EXPECT_EQ(rowOf(view, "Contact").passed, true);
}

}  // namespace
}  // namespace forge
