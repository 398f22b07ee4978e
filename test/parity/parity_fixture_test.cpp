#include "parity/parity_fixture.h"

namespace forge {
namespace {

TEST(ParityFixture, SaysThatAFileIsNotThere) {
  const ParityFixture fixture("no_such_file.json");
  EXPECT_FALSE(fixture.isThere());
  EXPECT_TRUE(fixture.cases("cases").empty());
}

TEST(ParityFixture, ReadsInfinityAndNumbers) {
  rapidjson::Document document;
  document.Parse(R"(["inf", 1.5])");
  EXPECT_EQ(numbersOf(document), (std::vector<double>{HUGE_VAL, 1.5}));
}

}  // namespace
}  // namespace forge
