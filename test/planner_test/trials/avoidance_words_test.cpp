#include "collision_forge/planner_test/trials/avoidance_words.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(AvoidanceWords, TellUntilWhenAManoeuvreWorks) {
  EXPECT_EQ(avoidanceWords(EvasiveManoeuvre::kBraking, 2.0, false), "up to 2.0 s by braking");
  EXPECT_EQ(avoidanceWords(EvasiveManoeuvre::kBoth, 3.5, true),
            "up to 3.5 s by steering and braking");
}

TEST(AvoidanceWords, CallAManoeuvreThatWorksFromNowOnAloneOneAtOnce) {
  EXPECT_EQ(avoidanceWords(EvasiveManoeuvre::kSteering, 0.0, false), "at once by steering");
}

TEST(AvoidanceWords, CallKeepingInAnAvoidanceTheRecordedDrive) {
  EXPECT_EQ(avoidanceWords(EvasiveManoeuvre::kKeeping, 0.0, false), "by driving as recorded");
}

TEST(AvoidanceWords, CallKeepingInAnEscapeKeepingTheSpeed) {
  EXPECT_EQ(avoidanceWords(EvasiveManoeuvre::kKeeping, 1.5, true),
            "by keeping its speed from 1.5 s on");
  EXPECT_EQ(avoidanceWords(EvasiveManoeuvre::kKeeping, 0.0, true), "by keeping its speed");
}

}  // namespace
}  // namespace forge
