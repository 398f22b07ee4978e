#include "collision_forge/attack/search/request_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "attack/search/added_scene.h"
#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const PredictionOptions kOptions = shippedOptions().prediction;

/// The ego and one car, 30 m apart.
Snapshot twoCars() {
  return snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                    {pastTrack("car", kCarSize, {30.0, 3.5, M_PI}, 10.0)}, emptyMap());
}

CollisionRequest asking(double tta, std::optional<std::string> attacker = std::nullopt) {
  CollisionRequest request = believableRequestFor(CollisionType::kRearEnd);
  request.tta = tta;
  request.attacker = std::move(attacker);
  return request;
}

void expectRefusal(const CollisionRequest& request, const Snapshot& snapshot, StatusCode code,
                   const std::vector<std::string>& parts) {
  const Status status = checkRequest(request, snapshot, kOptions);
  EXPECT_STREQ(toString(status.code), toString(code)) << status.message;
  for (const std::string& part : parts) {
    EXPECT_NE(status.message.find(part), std::string::npos) << part << ": " << status.message;
  }
}

TEST(WithFullId, AcceptsAUniquePrefixOfAnId) {
  Snapshot snapshot = twoCars();
  snapshot.agents = {pastTrack("33dd9cf264db", kCarSize, {30.0, 3.5, M_PI}, 10.0),
                     pastTrack("33dd9cf9", kCarSize, {60.0, 3.5, M_PI}, 10.0),
                     pastTrack("519c8d", kCarSize, {90.0, 3.5, M_PI}, 10.0)};
  const auto fullId = [&](const std::string& id) {
    return *withFullId(asking(4.0, id), snapshot).attacker;
  };
  EXPECT_EQ(fullId("33dd9cf2"), "33dd9cf264db");
  EXPECT_EQ(fullId("33dd9cf264db"), "33dd9cf264db");
  EXPECT_EQ(fullId("519c8d"), "519c8d");
  EXPECT_EQ(fullId("33dd9c"), "33dd9c") << "both begin so";
  EXPECT_EQ(fullId("33dd9cf264dbff"), "33dd9cf264dbff");
  EXPECT_EQ(fullId("519c8"), "519c8") << "too short";
  EXPECT_FALSE(withFullId(asking(4.0), snapshot).attacker);
}

TEST(IsCandidate, AcceptsAVehicleObservedNowAndBefore) {
  const Snapshot snapshot = twoCars();
  EXPECT_TRUE(isCandidate(snapshot.agents[0], snapshot, kOptions));
}

TEST(IsCandidate, RejectsATractorWithItsTrailer) {
  Snapshot snapshot = twoCars();
  snapshot.agents[0].agent_class = AgentClass::kTruck;
  snapshot.agents.push_back(pastTrack("trailer", kCarSize, {34.7, 3.5, M_PI}, 10.0));
  snapshot.agents[1].agent_class = AgentClass::kTrailer;
  EXPECT_FALSE(isCandidate(snapshot.agents[0], snapshot, kOptions));
  expectRefusal(asking(4.0, "car"), snapshot, StatusCode::kAbsentAttacker,
                {"\"car\" forms one vehicle with trailer \"trailer\""});
}

TEST(IsCandidate, DependsOnTheClass) {
  Snapshot snapshot = twoCars();
  for (const auto& [agent_class, expected] :
       std::vector<std::pair<AgentClass, bool>>{{AgentClass::kTruck, true},
                                                {AgentClass::kBus, true},
                                                {AgentClass::kTrailer, false},
                                                {AgentClass::kBicycle, false},
                                                {AgentClass::kPedestrian, false},
                                                {AgentClass::kChild, false},
                                                {AgentClass::kRunner, false},
                                                {AgentClass::kScooter, false},
                                                {AgentClass::kStaticObject, false}}) {
    snapshot.agents[0].agent_class = agent_class;
    EXPECT_EQ(isCandidate(snapshot.agents[0], snapshot, kOptions), expected)
        << toString(agent_class);
  }
}

TEST(IsCandidate, MustBeWithinTheRadiusOfTheEgo) {
  const auto at = [](double x) {
    const Snapshot snapshot =
        snapshotOf(pastTrack(kEgoId, kEgoSize, {5.0, 0.0, 0.0}, 10.0),
                   {pastTrack("car", kCarSize, {x, 0.0, 0.0}, 10.0)}, emptyMap());
    return isCandidate(snapshot.agents[0], snapshot, kOptions);
  };
  EXPECT_TRUE(at(84.9));
  EXPECT_FALSE(at(85.1));
  EXPECT_TRUE(at(-74.9));
  EXPECT_FALSE(at(-75.1));
}

TEST(IsCandidate, MustBePresentNowAndBefore) {
  const auto with = [](const std::vector<double>& times) {
    Snapshot snapshot = twoCars();
    snapshot.agents[0].states.clear();
    for (const double time : times) {
      snapshot.agents[0].states.push_back({kNow + time, {30.0 + time, 3.5, 0.0}, {1.0, 0.0}});
    }
    return isCandidate(snapshot.agents[0], snapshot, kOptions);
  };
  EXPECT_TRUE(with({-0.5, 0.0}));
  EXPECT_FALSE(with({-1.0, -0.5}));
  EXPECT_FALSE(with({0.0}));
  EXPECT_FALSE(with({-3.0, 0.0})) << "its motion is unknown after a gap";
}

TEST(IsCandidate, NeedsAFinitePoseAndASize) {
  Snapshot snapshot = twoCars();
  snapshot.agents[0].states[0].pose.y = kNan;
  EXPECT_FALSE(isCandidate(snapshot.agents[0], snapshot, kOptions));
  snapshot = twoCars();
  snapshot.agents[0].size.length = 0.0;
  EXPECT_FALSE(isCandidate(snapshot.agents[0], snapshot, kOptions));
  snapshot.agents[0].size = {4.0, kNan};
  EXPECT_FALSE(isCandidate(snapshot.agents[0], snapshot, kOptions));
}

TEST(CheckRequest, AcceptsValidRequests) {
  for (const double tta : {0.5, 4.0, 9.0}) {
    EXPECT_EQ(checkRequest(asking(tta), twoCars(), kOptions).code, StatusCode::kOk);
    EXPECT_EQ(checkRequest(asking(tta, "car"), twoCars(), kOptions).code, StatusCode::kOk);
  }
}

TEST(CheckRequest, RejectsOptionsThatAdaptiveModeDoesNotSupport) {
  CollisionRequest request = asking(4.0);
  request.mode = Mode::kAdaptive;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.alternatives = 3;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"alternatives = 3", "adaptive"});
  request.alternatives = 1;
  request.crash.believable = false;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.crash.limits = LimitSet::kStrict;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"limits = strict", "adaptive"});
}

TEST(CheckRequest, RejectsATtaOutOfRange) {
  for (const auto& [tta, text] : std::vector<std::pair<double, std::string>>{
           {0.49, "0.49"}, {9.01, "9.01"}, {-1.0, "-1"}, {0.0, "0"}, {kNan, "nan"}}) {
    expectRefusal(asking(tta), twoCars(), StatusCode::kTtaOutOfRange,
                  {"tta = " + text, "0.5", "9 s"});
  }
}

TEST(CheckRequest, RejectsTooLittleHistoryOfTheEgo) {
  Snapshot snapshot = twoCars();
  snapshot.ego.states.erase(snapshot.ego.states.begin(), snapshot.ego.states.end() - 2);
  EXPECT_EQ(checkRequest(asking(4.0), snapshot, kOptions).code, StatusCode::kOk);
  snapshot.ego.states.erase(snapshot.ego.states.begin());
  expectRefusal(asking(4.0), snapshot, StatusCode::kTooLittleHistory, {"ego", "1 frames", "2"});
  snapshot.ego.states.clear();
  expectRefusal(asking(4.0), snapshot, StatusCode::kTooLittleHistory, {"ego", "0 frames"});
}

TEST(CheckRequest, RejectsAnEgoWithoutMotionAfterAGap) {
  Snapshot snapshot = twoCars();
  snapshot.ego.states.erase(snapshot.ego.states.begin() + 1, snapshot.ego.states.end() - 1);
  expectRefusal(asking(4.0), snapshot, StatusCode::kTooLittleHistory, {"ego"});
}

TEST(CheckRequest, RejectsUnknownAttackers) {
  expectRefusal(asking(4.0, "ghost"), twoCars(), StatusCode::kUnknownAttacker,
                {"attacker_id", "ghost"});
  expectRefusal(asking(4.0, ""), twoCars(), StatusCode::kUnknownAttacker, {"attacker_id", "\"\""});
}

TEST(CheckRequest, RejectsAbsentAndUnfitAttackers) {
  Snapshot snapshot = twoCars();
  snapshot.agents[0].agent_class = AgentClass::kAnimal;
  expectRefusal(asking(4.0, "car"), snapshot, StatusCode::kAbsentAttacker, {"car", "animal"});
  snapshot = twoCars();
  snapshot.agents[0].states.pop_back();
  expectRefusal(asking(4.0, "car"), snapshot, StatusCode::kAbsentAttacker, {"car", "not present"});
}

TEST(CheckRequest, RejectsAttackersWithoutHistory) {
  Snapshot snapshot = twoCars();
  auto& states = snapshot.agents[0].states;
  states.erase(states.begin(), states.end() - 1);
  expectRefusal(asking(4.0, "car"), snapshot, StatusCode::kTooLittleHistory, {"car"});
}

TEST(CheckRequest, RejectsAnAttackerIdWithChoiceNew) {
  CollisionRequest request = asking(4.0, "car");
  request.choice = AttackerChoice::kNew;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"choice = new", "\"car\""});
  request.choice = AttackerChoice::kExisting;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
}

TEST(CheckRequest, RejectsUnfitAndContradictingClasses) {
  CollisionRequest request = asking(4.0);
  request.attacker_class = AgentClass::kTrailer;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"attacker_class = trailer"});
  request.attacker_class = AgentClass::kTruck;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.attacker = "car";
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput,
                {"\"car\" is a car", "attacker_class = truck"});
}

TEST(CheckRequest, RejectsAManoeuvreOfAnotherType) {
  CollisionRequest request = asking(4.0);
  request.manoeuvre = Manoeuvre::kCutIn;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput,
                {"manoeuvre = cut_in", "rear_end", "lead_stopped"});
  request.manoeuvre = Manoeuvre::kLeadBrakes;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
}

TEST(CheckRequest, RejectsImpossibleImpactSpeeds) {
  CollisionRequest request = asking(4.0);
  for (const Range& range : {Range{5.0, 4.0}, Range{-1.0, 4.0}, Range{kNan, 4.0}, Range{1.0, kNan},
                             Range{0.0, std::numeric_limits<double>::infinity()}}) {
    request.impact_speed = range;
    expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"impact_speed = "});
  }
  request.impact_speed = Range{4.0, 4.0};
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
}

TEST(CheckRequest, RejectsImpossibleOverlaps) {
  CollisionRequest request = asking(4.0);
  for (const Range& range :
       {Range{0.9, 0.2}, Range{-0.1, 0.4}, Range{0.5, 1.01}, Range{kNan, 0.4}, Range{0.1, kNan}}) {
    request.overlap = range;
    expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"overlap = ", "0 to 1"});
  }
  for (const Range& range : {Range{0.4, 0.4}, Range{0.0, 1.0}}) {
    request.overlap = range;
    EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  }
}

TEST(CheckRequest, RejectsConditionsOutOfRange) {
  for (const RangeControl& control : kRangeControls) {
    CollisionRequest request = asking(4.0);
    for (const Range& range :
         {Range{0.5, 0.4}, Range{control.least - 0.1, 0.4}, Range{0.5, control.most + 0.1},
          Range{kNan, 0.4}, Range{0.1, kNan}}) {
      request.*control.asked = range;
      expectRefusal(request, twoCars(), StatusCode::kInvalidInput,
                    {std::string(control.name) + " ="});
    }
    request.*control.asked = Range{0.4, 0.4};
    EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk) << control.name;
  }
}

TEST(CheckRequest, AdaptiveAttackersAreNotHidden) {
  CollisionRequest request = asking(4.0);
  request.hidden_by = Hider::kParkedVehicle;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.mode = Mode::kAdaptive;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"hidden_by", "adaptive"});
}

TEST(CheckRequest, NamesConditionsThatContradictEachOther) {
  const auto expect_contradiction = [](const CollisionRequest& request,
                                       const std::vector<std::string>& fields) {
    expectRefusal(request, twoCars(), StatusCode::kInvalidInput, fields);
  };
  CollisionRequest request = asking(4.0);
  request.turning = Turning::kEgo;
  expect_contradiction(request, {"turning = ego", "ltap", "rear_end"});
  request.type = CollisionType::kLtap;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.manoeuvre = Manoeuvre::kTurnAcrossPath;
  expect_contradiction(request, {"turn_across_path", "turning = ego", "straight_crossing"});

  request = asking(4.0);
  request.type = CollisionType::kJunctionCrossing;
  request.manoeuvre = Manoeuvre::kBackOut;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.attacker_class = AgentClass::kBicycle;
  expect_contradiction(request, {"back_out", "attacker_class = bicycle"});
  request.attacker_class.reset();
  request.choice = AttackerChoice::kExisting;
  expect_contradiction(request, {"back_out", "choice = existing"});
  request.choice = AttackerChoice::kAny;
  request.mode = Mode::kAdaptive;
  expect_contradiction(request, {"back_out", "mode = adaptive"});
  request.mode = Mode::kHistory;
  request.crash.believable = false;
  expect_contradiction(request, {"back_out", "believable = false"});

  request = asking(4.0);
  request.from_side = Side::kLeft;
  expect_contradiction(request, {"from_side = left", "rear_end"});
  request.type = CollisionType::kLaneChange;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.ego_side = Side::kRight;
  expect_contradiction(request, {"from_side = left", "ego_side = right"});
  request.from_side = Side::kFront;
  expect_contradiction(request, {"from_side = front"});

  request = asking(4.0);
  request.impact_location = Range{0.2, 0.3};
  request.ego_side = Side::kRear;
  expect_contradiction(request, {"impact_location", "ego_side = rear"});
  request = asking(4.0);
  request.attacker_speed = Range{3.0, 5.0};
  request.lateral_speed = Range{5.5, 6.0};
  expect_contradiction(request, {"lateral_speed", "attacker_speed"});
  request.lateral_speed.reset();
  request.manoeuvre = Manoeuvre::kLeadStopped;
  expect_contradiction(request, {"attacker_speed", "lead_stopped"});
  request.attacker_speed.reset();
  request.deceleration = Range{2.0, 6.0};
  expect_contradiction(request, {"deceleration", "lead_stopped"});
  request.deceleration.reset();
  request.departure_time = Range{1.0, 2.0};
  expect_contradiction(request, {"departure_time", "lead_stopped"});
  request.manoeuvre.reset();
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.departure_time = Range{5.0, 6.0};
  expect_contradiction(request, {"departure_time = 5", "tta = 4"});
}

TEST(CheckRequest, AnAttackerThatMovesHasNoDepartureTime) {
  CollisionRequest request = asking(4.0, "car");
  request.departure_time = Range{0.5, 1.5};
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput,
                {"\"car\" moves at t0", "departure_time"});
}

TEST(CheckRequest, RejectsZeroAndTooManyAlternatives) {
  CollisionRequest request = asking(4.0);
  for (const int count : {-1, 0, kMaxAlternatives + 1}) {
    request.alternatives = count;
    expectRefusal(request, twoCars(), StatusCode::kInvalidInput,
                  {"alternatives = " + std::to_string(count), "1 to 16"});
  }
  request.alternatives = kMaxAlternatives;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
}

TEST(CheckRequest, RejectsBelievableAttacksWithStrictLimits) {
  CollisionRequest request = asking(4.0);
  request.crash.limits = LimitSet::kStrict;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"limits = strict", "believable"});
  request.crash.believable = false;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
}

TEST(CheckRequest, NamesAnInvalidSizeOrPoseOfTheAttacker) {
  Snapshot snapshot = twoCars();
  snapshot.agents[0].size.width = 0.0;
  expectRefusal(asking(4.0, "car"), snapshot, StatusCode::kInvalidInput, {"car", "size"});
  snapshot = twoCars();
  snapshot.agents[0].states.back().pose.x = kNan;
  expectRefusal(asking(4.0, "car"), snapshot, StatusCode::kInvalidInput, {"car", "pose"});
}

TEST(CheckRequest, PeopleOnFootAttackInAllModesButAdaptive) {
  AddedScene made;
  const AddedVehicleInput input = made.input();
  for (const AgentClass on_foot :
       {AgentClass::kPedestrian, AgentClass::kChild, AgentClass::kRunner}) {
    CollisionRequest request = believableRequestFor(CollisionType::kJunctionCrossing);
    request.attacker_class = on_foot;
    EXPECT_EQ(checkRequest(request, input.snapshot, shippedOptions().prediction).code,
              StatusCode::kOk);
    request.mode = Mode::kAdaptive;
    EXPECT_EQ(checkRequest(request, input.snapshot, shippedOptions().prediction).code,
              StatusCode::kInvalidInput);
  }
}

TEST(CheckRequest, AQueueNeedsAnAttackerThatStandsInTheLane) {
  CollisionRequest request = asking(4.0);
  request.queue = true;
  EXPECT_EQ(checkRequest(request, twoCars(), kOptions).code, StatusCode::kOk);
  request.manoeuvre = Manoeuvre::kLeadBrakes;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"queue = true", "lead_brakes"});
  request.manoeuvre.reset();
  request.mode = Mode::kAdaptive;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"queue = true", "adaptive"});
  request.mode = Mode::kReplay;
  request.type = CollisionType::kLaneChange;
  expectRefusal(request, twoCars(), StatusCode::kInvalidInput, {"queue = true", "lane_change"});
}

TEST(IsCandidate, BicyclesAndPedestriansAreCandidatesOnlyIfTheyAreNamed) {
  AddedScene scene;
  scene.add("a", {-30.0, 4.0, 0.0}, 4.0);
  scene.others.back().agent_class = AgentClass::kBicycle;
  const AddedVehicleInput input = scene.input();
  const Track& agent = input.snapshot.agents.front();
  const PredictionOptions options = shippedOptions().prediction;
  EXPECT_FALSE(isCandidate(agent, input.snapshot, options));
  EXPECT_FALSE(isCandidate(agent, input.snapshot, options, AgentClass::kPedestrian));
  EXPECT_TRUE(isCandidate(agent, input.snapshot, options, AgentClass::kBicycle));
}

}  // namespace
}  // namespace forge
