#include "collision_forge/report/attack_record.h"

#include <gmock/gmock.h>

#include "collision_forge/settings/config.h"
#include "report/report_scenes.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

VerificationOptions shippedOptions() {
  return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification;
}

TEST(AttackRecord, TellsTheLimitsThatTheRequestAsksFor) {
  Scenario scenario = rearEnd();
  const VerificationOptions options = shippedOptions();
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), HasSubstr(R"("of":"car")"));
  scenario.asked.request.crash.limits = LimitSet::kStrict;
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), HasSubstr(R"("of":"strict")"));
}

TEST(AttackRecord, HasWhatTheRecordingSaysWhereThatIsKnown) {
  const Scenario scenario = rearEnd();
  const VerificationOptions options = shippedOptions();
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), Not(HasSubstr("recorded\":{")));
  EXPECT_THAT(attackRecord(scenario, scenario.answer, CollisionReport(), options),
              HasSubstr(R"("recorded":{"contact":false)"));
}

TEST(PlannerRecord, HasTheMotionWhereItWasDrivenAgain) {
  PlannerTestResult result;
  result.now = kNow;
  PlannerRow row;
  row.outcome.contact = PlannerContact();
  row.outcome.contact->time = kNow + 1.5;
  EXPECT_THAT(plannerRecord(result, row, nullptr),
              AllOf(HasSubstr(R"("t":1.5)"), Not(HasSubstr("drive\":"))));
  RolloutOutcome driven = row.outcome;
  driven.driven = rearEnd().answer.trajectory.points;
  EXPECT_THAT(plannerRecord(result, row, &driven), HasSubstr(R"("drive":{"ego":{"t":[0,100)"));
}

}  // namespace
}  // namespace forge
