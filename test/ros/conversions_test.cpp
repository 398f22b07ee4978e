#include "collision_forge/ros/messages/conversions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "base/scene/whole_attack.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

TEST(StampOf, RestoresEveryTimeOfToday) {
  const double first = 1532402927.647951;  // s
  for (int i = 0; i < 10000; ++i) {
    const double time = first + 0.1 * i / 7.0;
    ASSERT_EQ(stampOf(time).toSec(), time);
  }
}

TEST(StampOf, RoundsToAWholeMicrosecond) {
  EXPECT_EQ(stampOf(1.000001), ros::Time(1, 1000));
  EXPECT_EQ(stampOf(1.0000014), ros::Time(1, 1400));
  EXPECT_EQ(stampOf(0.0), ros::Time(0, 0));
}

/// A lane with an outline and an area at northings of UTM, with coordinates that float32 rounds by
/// up to 0.25 m.
LaneMap farMap() {
  const Vector2 corner(500924.162, 4649776.224);
  const std::vector<Vector2> ring = {corner, corner + Vector2(40.1, 0.3),
                                     corner + Vector2(40.2, 3.7)};
  LaneMap map;
  Lane lane;
  lane.id = "a";
  lane.centerline = {{corner.x(), corner.y(), 0.0}, {corner.x() + 40.0, corner.y(), 0.0}};
  lane.polygon = ring;
  map.lanes = {lane};
  map.drivable_area = {{ring, {ring}}};
  map.walkways = {{ring, {}}};
  return map;
}

TEST(LaneMapMessage, PolygonsFarFromTheOriginOfTheMapKeepAMillimetre) {
  const LaneMap map = farMap();
  const collision_forge::LaneMap message = toMessage(map, ros::Time(1.0));
  EXPECT_EQ(message.origin.x, 61 * 8192.0);
  EXPECT_EQ(message.origin.y, 568 * 8192.0);
  const LaneMap read = fromMessage(message);
  const std::vector<Vector2>& ring = map.lanes[0].polygon;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (const std::vector<Vector2>* const got :
         {&read.lanes.at(0).polygon, &read.drivable_area.at(0).exterior,
          &read.drivable_area.at(0).holes.at(0), &read.walkways.at(0).exterior}) {
      EXPECT_LT((got->at(i) - ring[i]).norm(), 1e-3);
    }
  }
}

TEST(LaneMapMessage, SpeedLimitsAreKept) {
  LaneMap map = farMap();
  map.lanes.push_back(map.lanes[0]);
  map.lanes[1].speed_limit = 13.9;
  const LaneMap read = fromMessage(toMessage(map, ros::Time(1.0)));
  EXPECT_EQ(read.lanes.at(0).speed_limit, std::nullopt);
  EXPECT_EQ(read.lanes.at(1).speed_limit, 13.9);
}

TEST(LaneMapMessage, TheOriginOfALocalMapIsZero) {
  LaneMap map = farMap();
  map.lanes[0].centerline = {{3000.0, -3000.0, 0.0}, {3040.0, -3000.0, 0.0}};
  const collision_forge::LaneMap message = toMessage(map, ros::Time(1.0));
  EXPECT_EQ(message.origin.x, 0.0);
  EXPECT_EQ(message.origin.y, 0.0);
}

TEST(LaneMapMessage, FeaturesAreReadBack) {
  LaneMap map;
  map.features = {{FeatureKind::kMedian, {{1.0, 2.0}, {3.0, 4.0}}},
                  {FeatureKind::kBikeLane, {{5.0, 6.0}, {7.0, 8.0}}}};
  collision_forge::LaneMap message = toMessage(map, ros::Time(1));
  const LaneMap back = fromMessage(message);
  ASSERT_EQ(back.features.size(), 2U);
  EXPECT_EQ(back.features[0].kind, FeatureKind::kMedian);
  EXPECT_EQ(back.features[1].kind, FeatureKind::kBikeLane);
  EXPECT_EQ(back.features[0].points, map.features[0].points);
  message.features[0].kind = 10;
  EXPECT_THAT([&] { fromMessage(message); },
              testing::ThrowsMessage<MessageError>("map feature: kind = 10 does not exist"));
}

TEST(AttackerPath, WithTooFewPointsIsRefusedWithItsAttacker) {
  collision_forge::AttackerPath message;
  message.attacker_id = "added-1";
  message.spacing = 1.0;
  message.points.resize(3);
  EXPECT_THAT([&] { fromMessage(message); },
              testing::ThrowsMessage<MessageError>(
                  testing::HasSubstr("\"added-1\": reference path with 3")));
}

collision_forge::AttackerTrajectory drivenFor(int points) {
  collision_forge::AttackerTrajectory message;
  message.attacker_id = "a";
  message.size.x = 4.5;
  message.size.y = 2.0;
  for (int i = 0; i < points; ++i) {
    message.points.emplace_back();
    message.points.back().stamp = ros::Time(10.0 + 0.1 * i);
    message.points.back().pose.orientation.w = 1.0;
  }
  return message;
}

std::string complaintAbout(const collision_forge::AttackerTrajectory& message) {
  try {
    static_cast<void>(fromMessage(message));
  } catch (const MessageError& error) {
    return error.what();
  }
  return "";
}

TEST(AttackerTrajectoryMessage, MustHaveFiniteNumbersAndIncreasingTimes) {
  EXPECT_EQ(fromMessage(drivenFor(4)).points.size(), 4u);
  EXPECT_TRUE(fromMessage(drivenFor(0)).points.empty());
  auto message = drivenFor(4);
  message.points[2].pose.position.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaintAbout(message), "attacker a: points[2] is not finite");
  message = drivenFor(4);
  message.points[1].speed = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaintAbout(message), "attacker a: points[1] is not finite");
  message = drivenFor(4);
  message.size.y = 0.0;
  EXPECT_EQ(complaintAbout(message), "attacker a: size is not positive");
  message = drivenFor(4);
  message.points[3].stamp = message.points[2].stamp;
  EXPECT_EQ(complaintAbout(message),
            "attacker a: points[3].stamp is not later than the previous one");
  message = drivenFor(4);
  message.agent_class = 200;
  EXPECT_NE(complaintAbout(message), "");
}

TEST(AttackerTrajectoryMessage, HasAPastIfTheAttackerWasAdded) {
  auto message = drivenFor(2);
  for (const double time : {9.0, 9.5, 10.0}) {
    message.past.emplace_back();
    message.past.back().stamp = ros::Time(time);
    message.past.back().velocity_x = time;
  }
  EXPECT_EQ(complaintAbout(message), "attacker a: past is given, but added is false");
  message.added = true;
  const AttackerTrajectory read = fromMessage(message);
  EXPECT_TRUE(read.isAdded());
  ASSERT_EQ(read.past.size(), 3u);
  EXPECT_EQ(read.past[1].velocity.x(), 9.5);
  const auto again = toMessage(read);
  EXPECT_TRUE(again.added);
  EXPECT_EQ(again.past, message.past);
  message.past[2].stamp = message.past[1].stamp;
  EXPECT_EQ(complaintAbout(message),
            "attacker a: past[2].stamp is not later than the previous one");
  message.past[1].pose.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaintAbout(message), "attacker a: past[1] is not finite");
  message.past.clear();
  EXPECT_EQ(complaintAbout(message), "attacker a: added is true, but past is empty");
  EXPECT_FALSE(toMessage(fromMessage(drivenFor(2))).added);
}

collision_forge::CollisionRequest leadBrakes() {
  collision_forge::CollisionRequest message;
  message.collision_type = "rear_end";
  message.tta = 4.0;
  return message;
}

TEST(CollisionRequestMessage, OverridesTheConfiguredCrashDefinition) {
  CrashDefinition configured;
  configured.believable = false;
  configured.time_tolerance = 0.25;
  auto message = leadBrakes();
  auto request = std::get<CollisionRequest>(fromMessage(message, configured));
  EXPECT_EQ(request.choice, AttackerChoice::kAny);
  EXPECT_EQ(request.alternatives, 1);
  EXPECT_FALSE(request.crash.believable);
  EXPECT_EQ(request.crash.time_tolerance, 0.25);
  EXPECT_FALSE(request.attacker_class || request.manoeuvre || request.ego_side ||
               request.impact_speed || request.overlap);
  message.choice = "new";
  message.believable = "true";
  message.limits = "strict";
  message.attacker_class = "bus";
  message.manoeuvre = "lead_brakes";
  message.ego_side = "front";
  message.max_impact_speed = 6.0;
  message.max_overlap = 0.5;
  message.alternatives = 4;
  request = std::get<CollisionRequest>(fromMessage(message, configured));
  EXPECT_EQ(request.choice, AttackerChoice::kNew);
  EXPECT_TRUE(request.crash.believable);
  EXPECT_EQ(request.crash.limits, LimitSet::kStrict);
  EXPECT_EQ(request.attacker_class, AgentClass::kBus);
  EXPECT_EQ(request.manoeuvre, Manoeuvre::kLeadBrakes);
  EXPECT_EQ(request.ego_side, Side::kFront);
  ASSERT_TRUE(request.impact_speed);
  EXPECT_EQ(request.impact_speed->max, 6.0);
  ASSERT_TRUE(request.overlap);
  EXPECT_EQ(request.overlap->max, 0.5);
  EXPECT_EQ(request.alternatives, 4);
}

TEST(CollisionRequestMessage, RoundTripsConditions) {
  CollisionRequest request =
      std::get<CollisionRequest>(fromMessage(leadBrakes(), CrashDefinition()));
  EXPECT_FALSE(asksForConditions(request)) << "fields that are not set";
  request.turning = Turning::kEgo;
  request.from_side = Side::kRight;
  request.hidden_by = Hider::kLeader;
  request.queue = true;
  double value = 0.25;
  for (const RangeControl& control : kRangeControls) {
    request.*control.asked = Range{value, value + 0.125};
    value += 0.25;
  }
  const auto message = toMessage(request);
  const auto read = std::get<CollisionRequest>(fromMessage(message, CrashDefinition()));
  EXPECT_EQ(read.turning, Turning::kEgo);
  EXPECT_EQ(read.from_side, Side::kRight);
  EXPECT_EQ(read.hidden_by, Hider::kLeader);
  EXPECT_TRUE(read.queue);
  for (const RangeControl& control : kRangeControls) {
    ASSERT_TRUE(read.*control.asked) << control.name;
    EXPECT_EQ((read.*control.asked)->min, (request.*control.asked)->min) << control.name;
    EXPECT_EQ((read.*control.asked)->max, (request.*control.asked)->max) << control.name;
  }
  collision_forge::CollisionRequest wrong = leadBrakes();
  wrong.turning = "nobody";
  EXPECT_NE(std::get<Status>(fromMessage(wrong, CrashDefinition())).message.find("turning"),
            std::string::npos);
}

TEST(CollisionRequestMessage, NamesFieldAndValueOfAnUnknownWord) {
  using Message = collision_forge::CollisionRequest;
  const std::pair<const char*, std::string Message::*> fields[] = {
      {"choice", &Message::choice},
      {"believable", &Message::believable},
      {"limits", &Message::limits},
      {"attacker_class", &Message::attacker_class},
      {"manoeuvre", &Message::manoeuvre},
      {"ego_side", &Message::ego_side},
      {"mode", &Message::mode}};
  for (const auto& [name, field] : fields) {
    Message message = leadBrakes();
    message.*field = "odd";
    const auto read = fromMessage(message, {});
    const Status* status = std::get_if<Status>(&read);
    ASSERT_NE(status, nullptr) << name;
    EXPECT_EQ(status->code, StatusCode::kInvalidInput);
    EXPECT_EQ(status->message.rfind(std::string(name) + " = \"odd\"", 0), 0u) << status->message;
  }
}

TEST(CollisionRequestMessage, WordsIgnoreCase) {
  auto message = leadBrakes();
  message.collision_type = "Rear_End";
  message.choice = "Existing";
  message.mode = "Replay";
  message.believable = "FALSE";
  message.limits = "Strict";
  message.attacker_class = "Bus";
  message.manoeuvre = "Lead_Brakes";
  message.ego_side = "Rear";
  auto lower = message;
  for (auto* word : {&lower.collision_type, &lower.choice, &lower.mode, &lower.believable,
                     &lower.limits, &lower.attacker_class, &lower.manoeuvre, &lower.ego_side}) {
    *word = lowered(*word);
  }
  EXPECT_NE(lower, message);
  for (const auto& said : {lower, message}) {
    const auto read = toMessage(std::get<CollisionRequest>(fromMessage(said, {})));
    EXPECT_EQ(read.choice, "existing");
    EXPECT_EQ(read.mode, "replay");
    EXPECT_EQ(read.believable, "false");
    EXPECT_EQ(read.limits, "strict");
    EXPECT_EQ(read.attacker_class, "bus");
    EXPECT_EQ(read.manoeuvre, "lead_brakes");
    EXPECT_EQ(read.ego_side, "rear");
  }
}

TEST(CollisionRequestMessage, HistoryWithAdaptiveSetIsModeAdaptive) {
  collision_forge::GenerateCollision::Request asked;
  asked.adaptive = true;
  for (const char* mode : {"", "history", "HISTORY", "adaptive"}) {
    asked.mode = mode;
    EXPECT_EQ(requestIn(asked).mode, "adaptive") << mode;
  }
  for (const char* mode : {"replay", "odd"}) {
    asked.mode = mode;
    EXPECT_EQ(requestIn(asked).mode, mode);
  }
  asked.adaptive = false;
  asked.mode = "history";
  EXPECT_EQ(requestIn(asked).mode, "history");
}

TEST(CollisionRequestMessage, AdaptiveRequestsHaveNoMinimumConfidence) {
  CrashDefinition configured;
  configured.min_confidence = 0.3;
  auto message = leadBrakes();
  EXPECT_EQ(std::get<CollisionRequest>(fromMessage(message, configured)).crash.min_confidence, 0.3);
  message.mode = "adaptive";
  EXPECT_EQ(std::get<CollisionRequest>(fromMessage(message, configured)).crash.min_confidence, 0.0);
}

TEST(AttackMessage, AnAttackIsReadBackCompletely) {
  const double now = 1531883530.949817;
  const Attack attack = wholeAttack(now);
  expectSame(fromMessage(toMessage(attack, "search", now)), attack);
}

TEST(AttackMessage, NamesAnUnknownWord) {
  const double now = 1531883530.949817;
  collision_forge::Attack message = toMessage(wholeAttack(now), "search", now);
  message.report.ego_side = "top";
  try {
    static_cast<void>(fromMessage(message));
    FAIL();
  } catch (const MessageError& error) {
    EXPECT_STREQ(error.what(), "ego_side = \"top\" is unknown");
  }
}

TEST(AttackMessage, HasTheLastDecisionOfTheAttacker) {
  collision_forge::Attack message;
  setPlans({{10.0, 10.0, AttackerPhase::kAttacking, "sets out", {}},
            {12.0, 12.3, AttackerPhase::kDrivingOn, "the ego jumped", {}}},
           message);
  EXPECT_TRUE(message.adaptive);
  EXPECT_EQ(message.phase, "driving_on");
  EXPECT_EQ(message.decision, "the ego jumped");
  EXPECT_EQ(message.decided, ros::Time(12.3));
  EXPECT_EQ(message.plans, 2u);
  EXPECT_EQ(message.report.decision, "the ego jumped");
}

}  // namespace
}  // namespace forge
