#include "collision_forge/drawing/caption_text.h"

#include <gtest/gtest.h>

#include "drawing/sample_view.h"

namespace forge {
namespace {

/// The value of a row; empty without it.
std::string valueOf(const ScenarioView& view, const std::string& name) {
  for (const CaptionRow& row : reportRows(view)) {
    if (row.name == name) return row.value;
  }
  return "";
}

TEST(CaptionText, NamesTheAttackersClassAndOrigin) {
  ScenarioView view = sampleView();
  view.trajectory.agent_class = AgentClass::kConstructionVehicle;
  EXPECT_NE(detailsText(view).find("by a recorded construction vehicle, veh"), std::string::npos);
  view.trajectory.past = view.snapshot.agents.front().states;
  EXPECT_NE(detailsText(view).find("by an added construction vehicle"), std::string::npos);
}

TEST(CaptionText, TellsSpeedsNowAndAtContact) {
  ScenarioView view = sampleView();
  for (TrajectoryPoint& point : view.trajectory.points) {
    point.speed = 10.0 - (point.time - view.snapshot.now);  // brakes with 1 m/s2
  }
  EXPECT_EQ(valueOf(view, "Ego, m/s"), "5.0 now, 5.0 at contact");
  EXPECT_EQ(valueOf(view, "Attacker, m/s"), "10.0 now, 8.0 at contact");
  view.report.contact = false;
  EXPECT_EQ(valueOf(view, "Attacker, m/s"), "10.0 now, 8.0 then");
}

TEST(CaptionText, TheVerdictSaysAgainstWhatAndTheFirstConditionThatFails) {
  ScenarioView view = sampleView();
  EXPECT_EQ(verdictText(view), "verified against the recording");
  const auto reason = [&view] {
    return verdictText(view).substr(verdictText(view).find(": ") + 2);
  };
  view.report.first_other_id = "truck-of-a-long-name";
  EXPECT_EQ(reason(), "touches truck- first");
  view.report.limits_kept = false;
  EXPECT_EQ(reason(), "a limit broken");
  view.report.on_time = false;
  EXPECT_EQ(reason(), "another time");
  view.report.type_kept = false;
  EXPECT_EQ(reason(), "another type");
  view.report.contact = false;
  EXPECT_EQ(reason(), "no contact");
  EXPECT_EQ(verdictText(view).find("not verified against the recording"), 0U);
}

TEST(CaptionText, AnOutcomeTellsTimeAngleAndWhatIsNotAsAsked) {
  ScenarioView view = sampleView();
  view.report.relative_heading = -0.21;  // rad
  EXPECT_EQ(outcomeText(view).contact, "touches after 2.0 s, 12°");
  EXPECT_EQ(outcomeText(view).verdict, "as asked");
  view.report.first_other_id = "truck";
  EXPECT_EQ(outcomeText(view).verdict, "somebody else first");
  view.report.on_time = false;
  EXPECT_EQ(outcomeText(view).verdict, "another time");
  view.report.contact = false;
  EXPECT_EQ(outcomeText(view).contact, "no contact");
  EXPECT_EQ(outcomeText(view).verdict, "");
}

}  // namespace
}  // namespace forge
