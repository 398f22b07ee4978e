#include "collision_forge/base/scene/short_id.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(ShortId, ShortensLongIdsToSixLetters) {
  EXPECT_EQ(shortId("539b42b934f4d6d45c30fed20dc8337e"), "539b42");
  EXPECT_EQ(shortId("added-1"), "added-1");
  EXPECT_EQ(shortId("added-12"), "added-12");
  EXPECT_EQ(shortId(""), "");
}

}  // namespace
}  // namespace forge
