#include "collision_forge/base/scene/collision_request.h"

#include <gtest/gtest.h>

#include <set>

namespace forge {
namespace {

TEST(CollisionRequest, UnknownNamesAreNoMode) {
  for (const char* name : {"", "rear end", "rear_end ", "REAR", "unknown"}) {
    EXPECT_FALSE(modeFromString(name)) << name;
  }
}

TEST(CollisionRequest, ModeNamesAreReadBack) {
  for (const Mode mode : kModes) EXPECT_EQ(modeFromString(toString(mode)), mode);
  EXPECT_EQ(modeFromString("REPLAY"), Mode::kReplay);
}

TEST(CollisionRequest, ChoicesAreReadBack) {
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    EXPECT_EQ(attackerChoiceFromString(toString(choice)), choice);
  }
  EXPECT_FALSE(attackerChoiceFromString("old"));
}

TEST(CollisionRequest, StatusNamesAreDistinct) {
  std::set<std::string> names;
  for (int code = 0; code <= 17; ++code) names.insert(toString(static_cast<StatusCode>(code)));
  EXPECT_EQ(names.size(), 18u);
  EXPECT_EQ(names.count("UNKNOWN"), 0u);
  EXPECT_STREQ(toString(static_cast<StatusCode>(18)), "UNKNOWN");
  EXPECT_STREQ(toString(StatusCode::kTtaOutOfRange), "TTA_OUT_OF_RANGE");
}

TEST(CollisionRequest, StatusNamesAreReadBack) {
  for (int code = 0; code <= 17; ++code) {
    const auto status = static_cast<StatusCode>(code);
    EXPECT_EQ(statusCodeFromString(toString(status)), status);
  }
  for (const char* name : {"", "ok", "UNKNOWN", "OK "}) {
    EXPECT_FALSE(statusCodeFromString(name)) << name;
  }
}

}  // namespace
}  // namespace forge
