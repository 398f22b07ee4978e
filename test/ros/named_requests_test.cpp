#include "collision_forge/ros/messages/named_requests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

using collision_forge::GenerateCollision;
using testing::HasSubstr;

std::variant<std::vector<NamedRequest>, Status> requestsOf(
    const GenerateCollision::Request& message, GenerateCollision::Response& response) {
  static const RequestVocabulary vocabulary =
      readVocabulary(std::string(COLLISION_FORGE_SOURCE_DIR "/config"));
  CrashDefinition crash;
  crash.min_confidence = 0.3;
  return requestsOf(message, vocabulary, crash, response);
}

std::vector<NamedRequest> requestsOf(const GenerateCollision::Request& message) {
  GenerateCollision::Response response;
  return std::get<std::vector<NamedRequest>>(requestsOf(message, response));
}

Status refusalOf(const GenerateCollision::Request& message) {
  GenerateCollision::Response response;
  return std::get<Status>(requestsOf(message, response));
}

TEST(NamedRequests, ANameGivesItsCellsWithTheOtherFields) {
  GenerateCollision::Request message;
  message.name = "ccrb deceleration=4";
  message.tta = 3.0;
  message.attacker_class = "truck";
  message.mode = "replay";
  const auto requests = requestsOf(message);
  ASSERT_EQ(requests.size(), 5U);
  EXPECT_EQ(requests[1].name, "euro_ncap_2026/CCRb deceleration=4 impact_location=0.25");
  EXPECT_EQ(requests[1].request.manoeuvre, Manoeuvre::kLeadBrakes);
  EXPECT_EQ(requests[1].request.attacker_class, AgentClass::kTruck);
  EXPECT_EQ(requests[1].request.tta, 3.0);
  EXPECT_EQ(requests[1].request.mode, Mode::kReplay);
  EXPECT_EQ(requests[1].request.crash.min_confidence, 0.3);
}

TEST(NamedRequests, ATextIsReadAndEchoed) {
  GenerateCollision::Request message;
  message.text = "purple truck cuts in from the left in 3 s";
  message.choice = "new";
  GenerateCollision::Response response;
  const auto requests = std::get<std::vector<NamedRequest>>(requestsOf(message, response));
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].request.type, CollisionType::kLaneChange);
  EXPECT_EQ(requests[0].request.tta, 3.0);
  EXPECT_EQ(requests[0].request.choice, AttackerChoice::kNew);
  EXPECT_THAT(response.not_understood, testing::ElementsAre("purple"));
  EXPECT_EQ(response.understood.size(), 5U);
}

TEST(NamedRequests, ATypeGivesOneRequestWithoutAName) {
  GenerateCollision::Request message;
  message.collision_type = "RE";
  message.tta = 4.0;
  const auto requests = requestsOf(message);
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].name, "");
  EXPECT_EQ(requests[0].request.type, CollisionType::kRearEnd);
}

TEST(NamedRequests, UnknownNamesAndContradictionsAreRefused) {
  GenerateCollision::Request message;
  message.name = "CCRx";
  EXPECT_THAT(refusalOf(message).message, HasSubstr("did you mean CCR"));
  message.name = "CCRb deceleration=3";
  EXPECT_THAT(refusalOf(message).message, HasSubstr("did you mean deceleration="));
  message.name = "ELK_RE";
  EXPECT_THAT(refusalOf(message).message, HasSubstr("cannot be requested"));
  message.name = "CCRb";
  message.collision_type = "rear_end";
  EXPECT_THAT(refusalOf(message).message, HasSubstr("only one of the three"));
  message.collision_type = "";
  message.ego_side = "top";
  EXPECT_THAT(refusalOf(message).message, HasSubstr("ego_side = \"top\""));
}

}  // namespace
}  // namespace forge
