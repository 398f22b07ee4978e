#include "collision_forge/io/batch/ledger.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

ItemResult result(std::size_t index) { return {index, std::to_string(index), nullptr}; }

ItemResult failure(std::size_t index) {
  return {index, "", std::make_exception_ptr(std::runtime_error("broken"))};
}

TEST(Ledger, ReturnsResultsInOrder) {
  Ledger ledger(0, 3, 10);
  ledger.put(result(2));
  EXPECT_FALSE(ledger.next());
  ledger.put(result(0));
  EXPECT_EQ(ledger.next()->bytes, "0");
  EXPECT_FALSE(ledger.next());
  ledger.put(result(1));
  EXPECT_EQ(ledger.next()->bytes, "1");
  EXPECT_FALSE(ledger.isFinished());
  EXPECT_EQ(ledger.next()->bytes, "2");
  EXPECT_TRUE(ledger.isFinished());
}

TEST(Ledger, LimitsTheResultsThatWaitForASlowItem) {
  Ledger ledger(0, 100, 3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(ledger.deal(), i);
  ledger.put(result(1));
  ledger.put(result(2));
  EXPECT_FALSE(ledger.next());
  EXPECT_FALSE(ledger.deal()) << "three are under way or wait for item 0";
  ledger.put(result(0));
  EXPECT_TRUE(ledger.next());
  EXPECT_EQ(ledger.deal(), 3u);
  EXPECT_FALSE(ledger.deal());
}

TEST(Ledger, AssignsNothingAfterAFailureAndReturnsEarlierResults) {
  Ledger ledger(0, 100, 10);
  for (std::size_t i = 0; i < 4; ++i) ledger.deal();
  ledger.put(failure(2));
  EXPECT_FALSE(ledger.deal());
  ledger.put(result(1));
  ledger.put(result(0));
  EXPECT_EQ(ledger.next()->bytes, "0");
  EXPECT_EQ(ledger.next()->bytes, "1");
  EXPECT_TRUE(ledger.next()->error);
}

}  // namespace
}  // namespace forge
