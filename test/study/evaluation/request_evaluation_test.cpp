#include "collision_forge/study/evaluation/request_evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "collision_forge/attack/search/request_list.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/io/answers/request_solver.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kDataroot = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
const std::vector<std::string> kHistoryMethods = {"constant_velocity", "nominal", "search",
                                                  "replay"};

bool meets(const ResultRow& row, const std::string& name) {
  const auto& measures = measuresOf(Protocol::kStrict);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (measures[i].name == name) return row.meets[i];
  }
  throw std::out_of_range(name);
}

const ResultRow& rowOf(const EvaluatedRequest& evaluated, const std::string& method) {
  return *std::find_if(evaluated.rows.begin(), evaluated.rows.end(),
                       [&](const ResultRow& row) { return row.method == method; });
}

std::vector<std::string> linesOf(const EvaluatedRequest& evaluated) {
  std::vector<std::string> lines;
  for (const ResultRow& row : evaluated.rows) lines.push_back(toCsv(row));
  return lines;
}

class RequestEvaluationTest : public testing::Test {
 protected:
  RequestEvaluationTest() { plan_.method = "search"; }

  const IndexedScene& scene(const std::string& name) { return *(held_ = scenes_.at(name)); }

  /// A request 4 s after the first frame of scene-0001.
  SceneRequest asked(CollisionType type) {
    SceneRequest request{"scene-0001", scene("scene-0001").scene.frame_times.at(8), {}};
    request.request.type = type;
    request.request.tta = 4.0;
    return request;
  }

  EvaluatedRequest evaluate(const SceneRequest& request) {
    return RequestEvaluator(scenes_, config_, {}, builtInMethods(), plan_).evaluate("7", request);
  }

  /// The strict outcome of an attack against the recording.
  StrictOutcome outcomeOf(const SceneRequest& request, const AttackerTrajectory& trajectory) {
    const auto moment = std::get<Moment>(momentAt(scene(request.scene), request.now, 8));
    CollisionRequest judged = request.request;
    judged.crash = config_.crash;
    judged.crash.limits = plan_.limits;
    judged.crash.believable = plan_.believable;
    return strictOutcome(trajectory, {moment.snapshot, *moment.recorded, judged, *moment.lanes},
                         config_.attack.verification);
  }

  StudyConfig config_ = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  SceneSource scenes_{{kDataroot, "v1.0-embedded"}, {"scene-0001", "scene-0007"}, config_, 1};
  std::shared_ptr<const IndexedScene> held_;
  EvaluationPlan plan_;
};

TEST_F(RequestEvaluationTest, HasARowPerMethodAndSeed) {
  plan_.seeds = 2;
  SceneRequest request = asked(CollisionType::kLaneChange);
  request.request.seed = 5;
  const EvaluatedRequest evaluated = evaluate(request);
  std::vector<std::string> expected = {"constant_velocity 5", "nominal 5"};
  std::vector<std::string> timed;
  for (std::size_t i = 2; i < kHistoryMethods.size(); ++i) {
    for (const char* seed : {" 5", " 6"}) expected.push_back(kHistoryMethods[i] + seed);
    timed.insert(timed.end(), 2, kHistoryMethods[i]);
  }
  std::vector<std::string> found;
  for (const ResultRow& row : evaluated.rows) {
    found.push_back(row.method + " " + std::to_string(row.seed));
    EXPECT_EQ(row.name, "7");
    EXPECT_EQ(row.scene, "scene-0001");
    EXPECT_EQ(row.type, CollisionType::kLaneChange);
    EXPECT_EQ(row.tta, 4.0);
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(evaluated.rows.size(), rowsPerRequest(plan_));
  ASSERT_EQ(evaluated.times.size(), timed.size());
  for (std::size_t i = 0; i < timed.size(); ++i) {
    EXPECT_EQ(evaluated.times[i].method, timed[i]);
    EXPECT_GT(evaluated.times[i].milliseconds, 0.01);
  }
}

TEST_F(RequestEvaluationTest, ReplayPlansHaveOneSearchAndNoneForBaselines) {
  EXPECT_EQ(requestRowMethods(plan_), kHistoryMethods);
  plan_.mode = Mode::kReplay;
  EXPECT_THAT(requestRowMethods(plan_), ElementsAre("constant_velocity", "nominal", "search"));
  EXPECT_EQ(rowsPerRequest(plan_), 3u);
  EXPECT_EQ(rowOf(evaluate(asked(CollisionType::kLaneChange)), "search").confidence, 1.0);
  plan_.method = "nominal";
  EXPECT_THAT(requestRowMethods(plan_), ElementsAre("constant_velocity", "nominal"));
  EXPECT_EQ(evaluate(asked(CollisionType::kLaneChange)).rows.size(), rowsPerRequest(plan_));
}

TEST_F(RequestEvaluationTest, SearchesEqualTheRequestSolver) {
  int answered = 0;
  for (const CollisionType type : kCollisionTypes) {
    const SceneRequest request = asked(type);
    plan_.believable = type == CollisionType::kRearEnd;
    plan_.limits = plan_.believable ? LimitSet::kDrivable : LimitSet::kStrict;
    const EvaluatedRequest evaluated = evaluate(request);
    for (const auto& [mode, name] :
         {std::pair(Mode::kHistory, "search"), std::pair(Mode::kReplay, "replay")}) {
      CrashDefinition crash = config_.crash;
      crash.limits = plan_.limits;
      crash.believable = plan_.believable;
      crash.min_confidence = 0.0;
      SceneRequest in_mode = request;
      in_mode.request.mode = mode;
      const Attack answer = RequestSolver(scenes_, {"search", builtInMethods(), config_.attack, {}},
                                          crash, config_.ego_vehicle, config_.adaptive)
                                .answer(in_mode)
                                .answer;
      const ResultRow& row = rowOf(evaluated, name);
      EXPECT_EQ(row.status, toString(answer.status.code));
      if (answer.status.code != StatusCode::kOk) {
        EXPECT_EQ(row.note, answer.status.message);
        EXPECT_THAT(row.meets, testing::Each(false));
        continue;
      }
      ++answered;
      const StrictOutcome outcome = outcomeOf(request, answer.trajectory);
      EXPECT_EQ(meets(row, "angle_bands"), outcome.meetsAngleBands());
      EXPECT_EQ(meets(row, "full_definitions"), outcome.meetsFullDefinitions());
      EXPECT_EQ(row.contact_after.has_value(), outcome.report.contact);
      EXPECT_EQ(row.confidence, answer.report.confidence);
      EXPECT_TRUE(mode == Mode::kHistory || meets(row, "full_definitions"));
      EXPECT_EQ(row.request->attacker, answer.trajectory.attacker_id);
      EXPECT_EQ(row.request->attacker_class, answer.trajectory.agent_class);
      EXPECT_EQ(row.request->believable.has_value(), outcome.report.contact);
      if (!outcome.report.contact) continue;
      EXPECT_EQ(*row.request->believable, outcome.report.believable());
    }
  }
  EXPECT_GT(answered, 3);
}

TEST_F(RequestEvaluationTest, AdaptiveAttackersAreMeasuredBesideFixedOnes) {
  plan_.mode = Mode::kHistory;
  const EvaluatedRequest fixed = evaluate(asked(CollisionType::kLaneChange));
  plan_.mode = Mode::kAdaptive;
  EXPECT_THAT(requestRowMethods(plan_),
              ElementsAre("constant_velocity", "nominal", "adaptive", "search", "replay"));
  const EvaluatedRequest evaluated = evaluate(asked(CollisionType::kLaneChange));
  ASSERT_EQ(evaluated.rows.size(), rowsPerRequest(plan_));
  EXPECT_EQ(toCsv(rowOf(evaluated, "search")), toCsv(rowOf(fixed, "search")));
  const ResultRow& row = rowOf(evaluated, "adaptive");
  ASSERT_EQ(row.status, "OK") << row.note;
  EXPECT_TRUE(meets(row, "limits_kept"));
  const auto looks = std::count_if(
      evaluated.times.begin(), evaluated.times.end(),
      [](const SearchTime& time) { return time.method == "adaptive, per update step"; });
  EXPECT_GT(looks, 4);
}

TEST_F(RequestEvaluationTest, ThePlanOverridesTheConfiguredCrash) {
  const SceneRequest request = asked(CollisionType::kRearEnd);
  const EvaluatedRequest shipped = evaluate(request);
  ASSERT_EQ(rowOf(shipped, "search").status, "OK");
  config_.crash.min_confidence = 1.0;
  config_.crash.limits = LimitSet::kStrict;
  config_.crash.believable = false;
  config_.crash.rules = TypeRules::kAngle;
  EXPECT_EQ(linesOf(evaluate(request)), linesOf(shipped));
}

TEST_F(RequestEvaluationTest, BaselinesWithoutAttackerUseTheBestCandidate) {
  plan_.method = "nominal";
  int met = 0;
  for (const CollisionType type : kCollisionTypes) {
    for (const double tta : {2.0, 4.0}) {
      SceneRequest request = asked(type);
      request.request.tta = tta;
      const EvaluatedRequest any = evaluate(request);
      const Snapshot snapshot =
          std::get<Moment>(momentAt(scene("scene-0001"), request.now, 8)).snapshot;
      for (const char* measure : {"angle_bands", "full_definitions", "contact"}) {
        for (const char* method : {"constant_velocity", "nominal"}) {
          bool by_one = false;
          for (const Track& agent : snapshot.agents) {
            request.request.attacker = agent.id;
            const EvaluatedRequest named = evaluate(request);
            by_one = by_one ||
                     (rowOf(named, method).status == "OK" && meets(rowOf(named, method), measure));
          }
          EXPECT_EQ(meets(rowOf(any, method), measure), by_one) << toString(type) << method;
          met += by_one;
        }
      }
    }
  }
  EXPECT_GT(met, 10);
}

TEST_F(RequestEvaluationTest, BaselinesAreJudgedOnlyByTheStrictLimits) {
  int kept = 0;
  for (const CollisionType type : kCollisionTypes) {
    for (const double tta : {2.0, 4.0, 6.0}) {
      SceneRequest request = asked(type);
      request.request.tta = tta;
      plan_.method = "nominal";
      plan_.believable = true;
      plan_.limits = LimitSet::kDrivable;
      const EvaluatedRequest by_default = evaluate(request);
      plan_.believable = false;
      plan_.limits = LimitSet::kStrict;
      EXPECT_EQ(linesOf(evaluate(request)), linesOf(by_default));
      for (const ResultRow& row : by_default.rows) {
        kept += meets(row, "contact") && meets(row, "limits_kept");
        EXPECT_EQ(row.request->attacker, "");
      }
    }
  }
  EXPECT_GT(kept, 0);
}

TEST_F(RequestEvaluationTest, RowsStateWhetherTheRoadAllowsTheRequest) {
  int allowed = 0;
  int refused = 0;
  for (const CollisionType type : kCollisionTypes) {
    const SceneRequest request = asked(type);
    const auto moment = std::get<Moment>(momentAt(scene(request.scene), request.now, 8));
    CollisionRequest judged = request.request;
    judged.crash = config_.crash;
    const bool allows = roadAllows(moment.recorded->ego, request.now, judged, *moment.lanes,
                                   config_.attack.verification.believability);
    (allows ? allowed : refused) += 1;
    for (const ResultRow& row : evaluate(request).rows) {
      EXPECT_EQ(row.request->road_allows, allows);
      const bool knows = row.method == "replay";
      EXPECT_FALSE(knows && !allows && row.status == "OK");
    }
  }
  EXPECT_GT(allowed, 0);
  EXPECT_GT(refused, 0);
}

TEST_F(RequestEvaluationTest, UnsolvableRequestsHaveTheirStatusInEveryRow) {
  std::vector<std::pair<SceneRequest, std::string>> impossible(
      3, {asked(CollisionType::kRearEnd), "UNKNOWN_ATTACKER"});
  impossible[0].first.request.attacker = "nobody";
  impossible[1].first.now += 0.1;
  impossible[1].second = "NO_SCENE";
  impossible[2].first.now = scene("scene-0001").scene.frame_times.back();
  impossible[2].second = "BEYOND_RECORDING";
  for (const auto& [request, status] : impossible) {
    const EvaluatedRequest evaluated = evaluate(request);
    EXPECT_EQ(evaluated.rows.size(), rowsPerRequest(plan_));
    for (const ResultRow& row : evaluated.rows) {
      EXPECT_EQ(row.status, status) << row.method;
      EXPECT_THAT(row.meets, testing::Each(false));
      EXPECT_FALSE(row.note.empty());
      EXPECT_FALSE(row.confidence);
    }
  }
}

}  // namespace
}  // namespace forge
