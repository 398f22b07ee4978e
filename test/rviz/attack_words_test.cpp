#include "collision_forge/ros/rviz/attack_words.h"

#include <gmock/gmock.h>

namespace forge {
namespace {

using testing::HasSubstr;
using testing::Not;

collision_forge::Attack attackAt(double now) {
  collision_forge::Attack attack;
  attack.header.stamp = ros::Time(now);
  attack.pattern.collision_type = "rear_end";
  attack.trajectory.attacker_id = "a<b";
  attack.trajectory.points.resize(1);
  attack.trajectory.points[0].stamp = ros::Time(now + 6.0);
  attack.report.contact = true;
  attack.report.contact_time = ros::Time(now + 4.0);
  attack.report.manoeuvre = "lead_brakes";
  attack.report.believable = true;
  return attack;
}

collision_forge::CollisionReport testedOf(const collision_forge::Attack& attack) {
  collision_forge::CollisionReport tested = attack.report;
  tested.header = attack.header;
  tested.attacker_id = attack.trajectory.attacker_id;
  tested.type_kept = tested.on_time = tested.limits_kept = tested.verified = true;
  return tested;
}

std::string crashAt(double now, const collision_forge::Attack& attack,
                    const collision_forge::CollisionReport* tested) {
  return crashText(attack, tested, ros::Time(now)).toStdString();
}

TEST(AttackText, NamesTypeClassManoeuvreAndPlausibility) {
  const std::string text = attackText(attackAt(10.0)).toStdString();
  EXPECT_THAT(text, HasSubstr("<b>rear_end</b> by the recorded car"));
  EXPECT_THAT(text, HasSubstr("lead_brakes"));
  EXPECT_THAT(text, HasSubstr("4.00 s"));
  EXPECT_THAT(text, HasSubstr("yes"));
}

TEST(AttackText, NamesTheAttackerByTheIdInThePicture) {
  collision_forge::Attack attack = attackAt(10.0);
  attack.trajectory.attacker_id = "626d04ddfb6ad0fbce7bb269ab4d03e5";
  const std::string text = attackText(attack).toStdString();
  EXPECT_THAT(text, HasSubstr("car 626d04"));
  EXPECT_THAT(text, Not(HasSubstr("626d04d")));
}

TEST(OutcomeText, NamesTheTouchedAgentAndTheFault) {
  collision_forge::PlannerOutcome outcome;
  outcome.planner = "idm";
  outcome.failure = "none";
  outcome.duration = 6.0;
  EXPECT_EQ(outcomeText(outcome).toStdString(), "<b>idm</b>: no contact in 6.0 s");
  outcome.collided = outcome.at_fault = true;
  outcome.contact_time = ros::Time(2.5);
  outcome.impact_speed = 4.0;
  outcome.other_id = "626d04ddfb6ad0fbce7bb269ab4d03e5";
  EXPECT_EQ(outcomeText(outcome).toStdString(),
            "<b>idm</b>: touches 626d04 after 2.50 s, 4.0 m/s, at fault");
  outcome.is_attacker = true;
  EXPECT_THAT(outcomeText(outcome).toStdString(), HasSubstr("touches the attacker after"));
}

TEST(OutcomeText, GivesTheReasonOfAFailure) {
  collision_forge::PlannerOutcome outcome;
  outcome.planner = "external";
  outcome.failure = "timed_out";
  outcome.failure_message = "no answer";
  EXPECT_THAT(outcomeText(outcome).toStdString(), HasSubstr("fails, timed_out: no answer"));
}

TEST(AttackText, GivesTheReasonWhyAMotionIsImplausible) {
  collision_forge::Attack attack = attackAt(10.0);
  attack.report.believable = false;
  attack.report.unbelievable = "drives on a walkway";
  EXPECT_THAT(attackText(attack).toStdString(), HasSubstr("no: it drives on a walkway"));
}

TEST(CrashText, CountsDownUntilTheContact) {
  const collision_forge::Attack attack = attackAt(10.0);
  const collision_forge::CollisionReport tested = testedOf(attack);
  EXPECT_THAT(crashAt(11.5, attack, nullptr), HasSubstr("contact in 2.5 s"));
  EXPECT_THAT(crashAt(11.5, attack, &tested), HasSubstr("contact in 2.5 s"));
}

TEST(CrashText, GivesTheVerdictInGreenOrRed) {
  const collision_forge::Attack attack = attackAt(10.0);
  collision_forge::CollisionReport tested = testedOf(attack);
  const std::string as_requested = crashAt(14.5, attack, &tested);
  EXPECT_THAT(as_requested, HasSubstr("contact as requested"));
  tested.verified = tested.on_time = false;
  const std::string not_as_requested = crashAt(14.5, attack, &tested);
  EXPECT_THAT(not_as_requested, HasSubstr("at another time"));
  EXPECT_NE(as_requested.substr(0, as_requested.find('>')),
            not_as_requested.substr(0, not_as_requested.find('>')));
}

}  // namespace
}  // namespace forge
