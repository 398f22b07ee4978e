#include "collision_forge/planner_test/trials/planner_run.h"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::HasSubstr;

/// Cases with these names; the case "broken" is unreadable.
class SampleCases : public PlannerCases {
 public:
  explicit SampleCases(std::vector<std::string> names) : names_(std::move(names)) {}
  const std::vector<std::string>& names() const override { return names_; }
  std::string fingerprint() const override { return "sample"; }
  PlannerCase at(std::size_t index) const override {
    if (names_[index] == "broken") throw std::runtime_error("no such scene");
    PlannerCase one;
    one.name = names_[index];
    return one;
  }

 private:
  std::vector<std::string> names_;
};

PlannerTestResult decline(const PlannerCase& one) { return untested(one, "UNFIT", "a sample"); }

class PlannerRunTest : public testing::Test {
 protected:
  forge::Run run() const {
    forge::Run run;
    run.path = folder_.path() + "/results.jsonl";
    run.options = {{"cases", "sample"}};
    return run;
  }

  TemporaryFolder folder_;
};

TEST_F(PlannerRunTest, ReturnsResultsInOrderWithUnreadableCases) {
  const auto results = testCases(run(), SampleCases({"a", "broken", "c"}), decline);
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].name, "a");
  EXPECT_EQ(results[0].status, "UNFIT");
  EXPECT_EQ(results[1].name, "broken");
  EXPECT_EQ(results[1].status, kUnreadable);
  EXPECT_EQ(results[1].message, "no such scene");
  EXPECT_EQ(results[2].name, "c");
}

TEST_F(PlannerRunTest, ReturnsResultsOfAnEarlierRun) {
  testCases(run(), SampleCases({"a", "b"}), decline);
  const auto results = testCases(
      run(), SampleCases({"a", "b"}),
      [](const PlannerCase&) -> PlannerTestResult { throw std::logic_error("was tested before"); });
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[1].name, "b");
}

TEST_F(PlannerRunTest, AResultOfAnotherCaseIsRejected) {
  testCases(run(), SampleCases({"a", "b"}), decline);
  try {
    testCases(run(), SampleCases({"a", "c"}), decline);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("results.jsonl: line 2: name = \"b\""));
  }
}

}  // namespace
}  // namespace forge
