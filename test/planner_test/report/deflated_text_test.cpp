#include "collision_forge/planner_test/report/deflated_text.h"

namespace forge {
namespace {

TEST(DeflatedText, IsBase64InGroupsOfFour) {
  for (const char* text : {"", "a", "ab", "abc", "abcd"}) {
    const std::string packed = deflatedText(text);
    EXPECT_EQ(packed.size() % 4, 0u) << text;
    EXPECT_EQ(
        packed.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                                 "+/="),
        std::string::npos)
        << text;
  }
}

TEST(DeflatedText, MatchesZlib) {
  // python3: base64.b64encode(zlib.compress(b'hello', 9))
  EXPECT_EQ(deflatedText("hello"), "eNrLSM3JyQcABiwCFQ==");
}

}  // namespace
}  // namespace forge
