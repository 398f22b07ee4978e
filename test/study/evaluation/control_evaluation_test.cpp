#include "collision_forge/study/evaluation/control_evaluation.h"

#include <gtest/gtest.h>

#include <map>

#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const std::string kDataroot = COLLISION_FORGE_SOURCE_DIR "/data/embedded";

class ControlEvaluatorTest : public testing::Test {
 protected:
  std::vector<ControlQuestion> questionsOn(CollisionType type) {
    const double now = scenes_.at("scene-0001")->scene.frame_times.at(8);
    SceneRequest listed{"scene-0001", now, {}};
    listed.request.type = type;
    listed.request.tta = 4.0;
    listed.request.crash = config_.crash;
    return controlQuestions("1", listed, config_.evaluation.controls);
  }

  const StudyConfig config_ = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  SceneSource scenes_{{kDataroot, "v1.0-embedded"}, {"scene-0001"}, config_, 1};
  const ControlEvaluator evaluator_{scenes_, loadMethod("search", config_, config_.attack), config_,
                                    config_.ego_vehicle};
};

TEST_F(ControlEvaluatorTest, EveryAttackOfTheSearchMeetsItsControl) {
  int answered = 0;
  for (const ControlQuestion& question : questionsOn(CollisionType::kRearEnd)) {
    const ControlAnswer answer = evaluator_.answer(question);
    EXPECT_EQ(answer.kept, answer.status == StatusCode::kOk)
        << question.control << " " << question.value;
    answered += answer.kept;
  }
  EXPECT_GT(answered, 5);
}

TEST_F(ControlEvaluatorTest, AnAttackViolatesAControlWithAnotherValue) {
  const auto scene = scenes_.at("scene-0001");
  const std::vector<ControlQuestion> questions = questionsOn(CollisionType::kRearEnd);
  const SceneRequest& plain = questions.front().asked;
  const Moment moment = std::get<Moment>(momentAt(*scene, plain.now, 8));
  const auto method = loadMethod("search", config_, config_.attack).make();
  const Realization attack =
      generateCollision(*method, moment, plain.request, config_.attack.prediction);
  ASSERT_EQ(attack.status.code, StatusCode::kOk) << attack.status.message;
  std::map<std::string, int> kept;
  for (const ControlQuestion& question : questions) {
    kept[question.control] += keepsControls(attack.trajectory, question.asked.request, moment,
                                            config_.attack.verification);
  }
  // An attack has exactly one value of each control; bands share only their ends.
  for (const auto& [control, count] : kept) EXPECT_EQ(count, 1) << control;
}

TEST_F(ControlEvaluatorTest, ATimeWithoutAFrameHasAStatus) {
  ControlQuestion question = questionsOn(CollisionType::kRearEnd).front();
  question.asked.now += 0.1;
  EXPECT_EQ(evaluator_.answer(question).status, StatusCode::kNoScene);
}

ControlQuestion overlapQuestion() {
  ControlQuestion question{"12", {"scene-0003", 1.0, {}}, "overlap", "0 to 0.25"};
  question.asked.request.type = CollisionType::kLtap;
  question.asked.request.tta = 3.5;
  return question;
}

TEST(ControlCsv, RoundTrips) {
  const ControlQuestion question = overlapQuestion();
  const std::pair<ControlAnswer, std::string> cases[] = {
      {{StatusCode::kOk, true}, "OK,1"},
      {{StatusCode::kOk, false}, "OK,0"},
      {{StatusCode::kNoCandidate, false}, "NO_CANDIDATE,"}};
  for (const auto& [answer, end] : cases) {
    const std::string line = toCsv(question, answer);
    EXPECT_EQ(line, "12,scene-0003,ltap,3.5,overlap,0 to 0.25," + end);
    const auto read = controlAnswerFromCsv(line, question);
    ASSERT_TRUE(read) << line;
    EXPECT_EQ(read->status, answer.status);
    EXPECT_EQ(read->kept, answer.kept);
  }
}

TEST(ControlCsv, LinesOfOtherQuestionsAndMalformedLinesAreRejected) {
  const ControlQuestion question = overlapQuestion();
  const std::string asked = "12,scene-0003,ltap,3.5,overlap,0 to 0.25,";
  for (const std::string& line :
       {std::string(), asked, asked + "OK", asked + "OK,", asked + "OK,2", asked + "FINE,1",
        asked + "NO_CANDIDATE,1", "13" + asked.substr(2) + "OK,1"}) {
    EXPECT_FALSE(controlAnswerFromCsv(line, question)) << line;
  }
}

TEST(ControlCsv, ASceneWithCommasIsRejected) {
  ControlQuestion question = overlapQuestion();
  question.asked.scene = "a,b";
  EXPECT_THROW(toCsv(question, {}), std::runtime_error);
}

}  // namespace
}  // namespace forge
