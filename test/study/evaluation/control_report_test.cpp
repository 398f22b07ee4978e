#include "collision_forge/study/evaluation/control_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

using testing::HasSubstr;

AnsweredQuestion answered(CollisionType type, const std::string& control, const std::string& value,
                          StatusCode status, bool kept = true) {
  ControlQuestion question;
  question.name = "1";
  question.asked.scene = "scene-0001";
  question.control = control;
  question.value = value;
  question.asked.request.type = type;
  return {question, {status, kept}};
}

std::vector<AnsweredQuestion> questions() {
  using Type = CollisionType;
  return {answered(Type::kLtap, "manoeuvre", "turn_across_path", StatusCode::kOk),
          answered(Type::kLtap, "overlap", "0 to 0.25", StatusCode::kOk),
          answered(Type::kRearEnd, "manoeuvre", "lead_slow", StatusCode::kNoCandidate),
          answered(Type::kRearEnd, "overlap", "0 to 0.25", StatusCode::kOk, false),
          answered(Type::kLtap, "overlap", "0 to 0.25", StatusCode::kNoAttackWithinLimits),
          answered(Type::kLtap, "overlap", "0 to 0.25", StatusCode::kRoadDoesNotAllow)};
}

TEST(ControlRates, CountSolvedRequestsAndMetControls) {
  const std::vector<ControlRates> rates = controlRates(questions());
  ASSERT_EQ(rates.size(), 3u);
  EXPECT_EQ(rates[0].value, "turn_across_path");
  EXPECT_EQ(rates[1].value, "lead_slow") << "beside the other manoeuvre";
  EXPECT_EQ(rates[1].kept.trials, 0);
  const ControlRates& overlap = rates[2];
  EXPECT_EQ(overlap.control, "overlap");
  EXPECT_EQ(overlap.asked, 4);
  EXPECT_EQ(overlap.declined, 1);
  EXPECT_EQ(overlap.answered.trials, 3);
  EXPECT_DOUBLE_EQ(overlap.answered.value, 2.0 / 3.0);
  EXPECT_EQ(overlap.kept.trials, 2);
  EXPECT_DOUBLE_EQ(overlap.kept.value, 0.5);
  ASSERT_EQ(overlap.answered_by_type.size(), std::size(kCollisionTypes));
  for (std::size_t i = 0; i < std::size(kCollisionTypes); ++i) {
    const Rate& rate = overlap.answered_by_type[i];
    const bool is_ltap = kCollisionTypes[i] == CollisionType::kLtap;
    const bool is_rear_end = kCollisionTypes[i] == CollisionType::kRearEnd;
    EXPECT_EQ(rate.trials, is_ltap ? 2 : is_rear_end ? 1 : 0);
    EXPECT_DOUBLE_EQ(rate.value, is_ltap ? 0.5 : is_rear_end ? 1.0 : 0.0);
  }
}

TEST(ControlRates, AreWrittenAsCsv) {
  const std::string csv = toCsv(controlRates(questions()));
  EXPECT_EQ(csv.rfind("control,value,type,trials,answered,low,high,kept\n", 0), 0u);
  EXPECT_THAT(csv, HasSubstr("\noverlap,0 to 0.25,all,3,0.6667,,,0.5000\n"));
  EXPECT_THAT(csv, HasSubstr("\noverlap,0 to 0.25,ltap,2,0.5000,,,\n"));
  EXPECT_THAT(csv, HasSubstr("\nmanoeuvre,lead_slow,ltap,0,,,,\n"));
}

}  // namespace
}  // namespace forge
