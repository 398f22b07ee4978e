#include "collision_forge/base/scene/request_words.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace forge {
namespace {

TEST(RequestWords, ParsesEveryListedCollisionType) {
  std::string words = collisionTypeWords();
  for (char& letter : words) {
    if (letter == '(' || letter == ')' || letter == ',') letter = ' ';
  }
  std::istringstream stream(words);
  std::set<CollisionType> types;
  for (std::string word; stream >> word;) {
    ASSERT_TRUE(collisionTypeFromString(word)) << word;
    types.insert(*collisionTypeFromString(word));
  }
  EXPECT_EQ(types.size(), std::size(kAllCollisionTypes) + 1) << "with any";
}

TEST(RequestWords, ClassesAreReadBack) {
  for (int number = 0; number <= static_cast<int>(kLastAgentClass); ++number) {
    const auto agent_class = static_cast<AgentClass>(number);
    EXPECT_EQ(agentClassFromString(toString(agent_class)), agent_class);
  }
  for (const char* name : {"", "Car", "unknown", "truck "}) {
    EXPECT_FALSE(agentClassFromString(name)) << name;
  }
}

TEST(RequestWords, EveryManoeuvreOfCollideBelongsToOneOfItsTypes) {
  std::size_t found = 0;
  for (const CollisionType type : kCollisionTypes) {
    const std::string names = ", " + manoeuvreNames(type) + ",";
    for (const Manoeuvre manoeuvre : kManoeuvres) {
      const bool is_named =
          names.find(std::string(", ") + toString(manoeuvre) + ",") != std::string::npos;
      EXPECT_EQ(is_named, typeOf(manoeuvre) == type) << names << toString(manoeuvre);
      found += is_named;
    }
  }
  EXPECT_EQ(found, std::size(kManoeuvres) - 1) << "without same_direction_turn";
  EXPECT_EQ(typeOf(Manoeuvre::kSameDirectionTurn), CollisionType::kAngleSameDirection);
}

TEST(RequestWords, EveryTypeHasManoeuvres) {
  for (const CollisionType type : kAllCollisionTypes) EXPECT_FALSE(manoeuvresOf(type).empty());
  EXPECT_EQ(manoeuvresOf(CollisionType::kAny).size(), std::size(kManoeuvres));
}

TEST(RequestWords, AnAttackerThatATurningEgoMeetsGoesStraightOn) {
  EXPECT_EQ(manoeuvreNames(CollisionType::kLtap), "turn_across_path");
  EXPECT_EQ(manoeuvreNames(CollisionType::kLtap, Turning::kEgo), "straight_crossing");
}

TEST(RequestWords, ManoeuvresLeadToTheirPreCrashScenariosType) {
  EXPECT_EQ(typeOf(Manoeuvre::kLeadStopped), CollisionType::kRearEnd);
  EXPECT_EQ(typeOf(Manoeuvre::kFollowerCloses), CollisionType::kRearEnd);
  EXPECT_EQ(typeOf(Manoeuvre::kPullOut), CollisionType::kLaneChange);
  EXPECT_EQ(typeOf(Manoeuvre::kWrongWay), CollisionType::kOppositeDirection);
  EXPECT_EQ(typeOf(Manoeuvre::kTurnIntoPath), CollisionType::kJunctionCrossing);
  EXPECT_EQ(typeOf(Manoeuvre::kBackOut), CollisionType::kJunctionCrossing);
  EXPECT_EQ(typeOf(Manoeuvre::kTurnAcrossPath), CollisionType::kLtap);
}

}  // namespace
}  // namespace forge
