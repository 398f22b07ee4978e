#include "collision_forge/ros/messages/report_text.h"

#include <collision_forge/Agent.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A contact 4 s after now = 10 s, by a brake that began 1.5 s after it.
collision_forge::CollisionReport crash() {
  collision_forge::CollisionReport report;
  report.header.stamp = ros::Time(10.0);
  report.verified = report.contact = report.limits_kept = report.believable = 1;
  report.contact_time = ros::Time(14.0);
  report.relative_heading = M_PI / 2;
  report.ego_side = "front";
  report.attacker_side = "rear";
  report.impact_speed = 6.5;
  report.overlap = 0.5;
  report.off_road_share = 0.25;
  report.manoeuvre = "lead_brakes";
  report.manoeuvre_begin = ros::Time(11.5);
  return report;
}

TEST(ReportText, SaysWhatTheCrashIsLike) {
  EXPECT_EQ(lineOf(crash()),
            "crash as asked, 4.00 s from now, relative heading 90.00 degrees, attacker's rear to "
            "ego's front, impact speed 6.50 m/s, overlap 50.00 %, limits kept, 25.00 % off road, "
            "lead_brakes from 1.50 s on, believable");
}

TEST(ReportText, NamesWhatIsBroken) {
  collision_forge::CollisionReport report = crash();
  report.verified = report.limits_kept = report.believable = 0;
  report.broken_limit = "speed 70 m/s > 60 m/s";
  report.first_other_id = "somebody";
  report.unbelievable = "drives on a walkway";
  const std::string line = lineOf(report);
  EXPECT_THAT(line, HasSubstr("contact, not as asked"));
  EXPECT_THAT(line, HasSubstr("speed 70 m/s > 60 m/s"));
  EXPECT_THAT(line, HasSubstr("touches somebody first"));
  EXPECT_THAT(line, HasSubstr("not believable: it drives on a walkway"));
  EXPECT_THAT(line, Not(HasSubstr("limits kept")));
}

TEST(ReportText, SaysNothingOfAContactThatIsNone) {
  collision_forge::CollisionReport report = crash();
  report.contact = 0;
  EXPECT_EQ(lineOf(report), "no contact");
}

TEST(ReportText, BeginsASummaryWithTheAttacker) {
  collision_forge::Attack attack;
  attack.pattern.collision_type = "rear_end";
  attack.trajectory.attacker_id = "added-1";
  attack.trajectory.agent_class = collision_forge::Agent::BUS;
  attack.trajectory.added = 1;
  attack.report = crash();
  attack.report.confidence = 0.75;
  EXPECT_EQ(summaryOf(attack),
            "rear_end by added-1, an added bus, confidence 75 %: " + lineOf(attack.report));
  attack.trajectory.added = 0;
  EXPECT_THAT(summaryOf(attack), HasSubstr("a recorded bus"));
}

}  // namespace
}  // namespace forge
