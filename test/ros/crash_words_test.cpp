#include "collision_forge/ros/markers/crash_words.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

/// From 10 s on, contact at 13 s, trajectory to 14 s.
collision_forge::Attack attack() {
  collision_forge::Attack attack;
  attack.header.stamp = ros::Time(10.0);
  attack.trajectory.attacker_id = "a";
  attack.trajectory.points.resize(2);
  attack.trajectory.points[0].stamp = ros::Time(10.0);
  attack.trajectory.points[1].stamp = ros::Time(14.0);
  attack.report.contact = true;
  attack.report.contact_time = ros::Time(13.0);
  return attack;
}

collision_forge::CollisionReport tested() {
  collision_forge::CollisionReport report;
  report.header.stamp = ros::Time(10.0);
  report.attacker_id = "a";
  report.contact = report.verified = report.believable = true;
  report.type_kept = report.on_time = report.limits_kept = true;
  report.contact_time = ros::Time(13.1);
  report.impact_speed = 7.24;
  return report;
}

TEST(CrashWords, CountDownInTheTimeGiven) {
  EXPECT_EQ(countdownWords(attack(), ros::Time(10.6)), "contact in 2.4 s");
  EXPECT_EQ(countdownWords(attack(), ros::Time(13.2)), "contact predicted 0.2 s ago");
  collision_forge::Attack missed = attack();
  missed.report.contact = false;
  EXPECT_EQ(countdownWords(missed, ros::Time(10.6)), "no contact foreseen");
}

TEST(CrashWords, KnowNoVerdictBeforeTheContactNorOfAnotherAttack) {
  auto report = tested();
  EXPECT_EQ(verdictBy(ros::Time(13.0), attack(), &report), nullptr);
  EXPECT_EQ(verdictBy(ros::Time(13.1), attack(), &report), &report);
  EXPECT_EQ(verdictBy(ros::Time(13.1), attack(), nullptr), nullptr);
  report.attacker_id = "b";
  EXPECT_EQ(verdictBy(ros::Time(13.1), attack(), &report), nullptr);
  report = tested();
  report.header.stamp = ros::Time(9.5);
  EXPECT_EQ(verdictBy(ros::Time(13.1), attack(), &report), nullptr);
}

TEST(CrashWords, KnowOfNoContactAtTheTrajectorysEnd) {
  auto report = tested();
  report.contact = report.verified = false;
  EXPECT_EQ(verdictBy(ros::Time(13.9), attack(), &report), nullptr);
  EXPECT_EQ(verdictBy(ros::Time(14.0), attack(), &report), &report);
  EXPECT_EQ(verdictWords(report), "no contact\nbelievable");
}

TEST(CrashWords, TellTheVerdict) {
  auto report = tested();
  EXPECT_EQ(verdictWords(report), "contact as asked\nimpact 7.2 m/s\nbelievable");
  report.verified = report.on_time = report.believable = false;
  report.unbelievable = "is on an island";
  EXPECT_EQ(
      verdictWords(report),
      "contact not as asked: at another time\nimpact 7.2 m/s\nnot believable: is on an island");
}

TEST(CrashWords, PutTheVerdictInPlaceOfTheCountdown) {
  const auto report = tested();
  collision_forge::Attack adaptive = attack();
  adaptive.adaptive = true;
  adaptive.phase = "attacking";
  adaptive.decision = "aims anew";
  EXPECT_EQ(crashWords(adaptive, nullptr, ros::Time(12.0)),
            "contact in 1.0 s\nattacking: aims anew");
  EXPECT_EQ(crashWords(adaptive, &report, ros::Time(14.0)), verdictWords(report));
}

}  // namespace
}  // namespace forge
