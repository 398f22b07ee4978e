#include "collision_forge/study/evaluation/control_questions.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

const StudyConfig kConfig = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");

/// A request of a list with controls, which the questions must ignore.
SceneRequest listed(CollisionType type) {
  SceneRequest asked{"scene-0001", 12.5, {}};
  asked.request.type = type;
  asked.request.tta = 3.0;
  asked.request.seed = 7;
  asked.request.crash = kConfig.crash;
  asked.request.attacker = "a";
  asked.request.ego_side = Side::kLeft;
  return asked;
}

std::vector<ControlQuestion> questions(CollisionType type,
                                       ControlOptions options = {{0.0, 5.0, 9.5}, {0.0, 0.4}}) {
  return controlQuestions("3", listed(type), options);
}

int controlsIn(const CollisionRequest& request) {
  return (request.choice != AttackerChoice::kAny) + request.attacker_class.has_value() +
         request.manoeuvre.has_value() + request.ego_side.has_value() +
         request.impact_speed.has_value() + request.overlap.has_value();
}

TEST(ControlQuestions, SetOneControlAtATime) {
  for (const CollisionType type : kCollisionTypes) {
    for (const ControlQuestion& question : questions(type)) {
      const CollisionRequest& request = question.asked.request;
      EXPECT_EQ(question.name, "3");
      EXPECT_EQ(question.asked.scene, "scene-0001");
      EXPECT_EQ(question.asked.now, 12.5);
      EXPECT_EQ(request.type, type);
      EXPECT_EQ(request.tta, 3.0);
      EXPECT_EQ(request.seed, 7u);
      EXPECT_EQ(request.mode, Mode::kReplay);
      EXPECT_FALSE(request.attacker);
      EXPECT_EQ(controlsIn(request), question.control == "none" ? 0 : 1) << question.control;
      EXPECT_EQ(checkControls(request).code, StatusCode::kOk) << question.value;
    }
  }
}

TEST(ControlQuestions, HaveEachValueOnce) {
  std::set<std::string> manoeuvres;
  for (const CollisionType type : kCollisionTypes) {
    std::map<std::string, std::set<std::string>> values;
    for (const ControlQuestion& question : questions(type)) {
      EXPECT_TRUE(values[question.control].insert(question.value).second) << question.value;
    }
    EXPECT_EQ(values["none"], std::set<std::string>{"any"});
    EXPECT_EQ(values["choice"], (std::set<std::string>{"existing", "new"}));
    EXPECT_EQ(values["attacker_class"],
              (std::set<std::string>{"car", "truck", "bus", "construction_vehicle",
                                     "emergency_vehicle", "motorcycle"}));
    EXPECT_EQ(values["ego_side"], (std::set<std::string>{"front", "rear", "left", "right"}));
    EXPECT_EQ(values["impact_speed"], (std::set<std::string>{"0 to 5", "5 to 9.5"}));
    EXPECT_EQ(values["overlap"], std::set<std::string>{"0 to 0.4"});
    manoeuvres.insert(values["manoeuvre"].begin(), values["manoeuvre"].end());
  }
  EXPECT_EQ(manoeuvres.size(), std::size(kManoeuvres));
}

}  // namespace
}  // namespace forge
