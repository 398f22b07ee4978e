#include "collision_forge/io/batch/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

namespace forge {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPatience{10'000};

TEST(WorkerPool, WorksOnAsManyItemsAtATimeAsItHasThreads) {
  std::atomic<int> inside{0};
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  // Each item waits for two others: the test ends in time only if three threads work.
  WorkerPool pool(3, [&](std::size_t) {
    ++inside;
    while (inside < 3 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return std::string();
  });
  for (std::size_t i = 0; i < 3; ++i) pool.give(i);
  std::size_t count = 0;
  while (count < 3) count += pool.collect(kPatience).size();
  EXPECT_LT(std::chrono::steady_clock::now(), deadline);
}

TEST(WorkerPool, WantsOneItemMoreThanItHasThreads) {
  std::atomic<bool> may_end{false};
  WorkerPool pool(2, [&](std::size_t) {
    while (!may_end) std::this_thread::yield();
    return std::string();
  });
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(pool.wantsMore()) << i;
    pool.give(i);
  }
  EXPECT_FALSE(pool.wantsMore());
  may_end = true;
  std::size_t count = 0;
  while (count < 3) count += pool.collect(kPatience).size();
  EXPECT_TRUE(pool.wantsMore());
}

TEST(WorkerPool, KeepsTheException) {
  WorkerPool pool(1, [](std::size_t) -> std::string { throw std::out_of_range("too far"); });
  pool.give(7);
  const auto results = pool.collect(kPatience);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results[0].index, 7u);
  EXPECT_THROW(std::rethrow_exception(results[0].error), std::out_of_range);
}

TEST(WorkerPool, DropsPendingItemsWhenItEnds) {
  std::atomic<int> worked{0};
  std::atomic<bool> has_begun{false};
  {
    WorkerPool pool(1, [&](std::size_t) {
      has_begun = true;
      std::this_thread::sleep_for(milliseconds(50));
      ++worked;
      return std::string();
    });
    for (std::size_t i = 0; i < 5; ++i) pool.give(i);
    while (!has_begun) std::this_thread::yield();
  }
  EXPECT_GE(worked, 1) << "the one begun was finished";
  EXPECT_LT(worked, 5) << "others were dropped";
}

}  // namespace
}  // namespace forge
