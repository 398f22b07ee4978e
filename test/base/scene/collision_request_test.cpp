#include "collision_forge/base/scene/collision_request.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(CollisionRequest, ChoicesAreReadBack) {
  for (const AttackerChoice choice :
       {AttackerChoice::kAny, AttackerChoice::kExisting, AttackerChoice::kNew}) {
    EXPECT_EQ(attackerChoiceFromString(toString(choice)), choice);
  }
  EXPECT_FALSE(attackerChoiceFromString("old"));
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
