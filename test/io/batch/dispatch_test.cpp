#include "collision_forge/io/batch/dispatch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace forge {
namespace {

constexpr std::size_t kCount = 300;

/// Delays early items of each group of eight, so that results arrive out of order.
std::string slowly(std::size_t index) {
  std::this_thread::sleep_for(std::chrono::microseconds(200 * (8 - index % 8)));
  return std::to_string(index * index);
}

struct Taken {
  std::vector<std::size_t> indices;
  std::vector<std::string> bytes;

  void operator()(std::size_t index, const std::string& text) {
    indices.push_back(index);
    bytes.push_back(text);
  }
};

/// Checks that exactly the items [first, end) were taken, in order.
void expectTaken(const Taken& taken, std::size_t first, std::size_t end) {
  ASSERT_EQ(taken.indices.size(), end - first);
  for (std::size_t i = first; i < end; ++i) {
    EXPECT_EQ(taken.indices[i - first], i);
    EXPECT_EQ(taken.bytes[i - first], std::to_string(i * i));
  }
}

/// Returns the error message of dispatch(); "" if there is none.
template <typename Work, typename Take>
std::string errorOf(const Work& work, const Take& take, int jobs) {
  try {
    dispatch(kCount, work, take, {jobs, 0});
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(Dispatch, TakesInOrderWhateverTheNumberOfJobs) {
  for (const int jobs : {1, 2, 7}) {
    Taken taken;
    dispatch(kCount, slowly, std::ref(taken), {jobs, 0});
    expectTaken(taken, 0, kCount);
  }
}

TEST(Dispatch, LargeResultsArriveWhole) {
  const auto work = [](std::size_t index) {
    return std::string(1 << 20, static_cast<char>(index));
  };
  std::size_t count = 0;
  dispatch(20, work,
           [&](std::size_t index, const std::string& bytes) {
             EXPECT_EQ(bytes, work(index));
             ++count;
           },
           {1, 0});
  EXPECT_EQ(count, 20u);
}

TEST(Dispatch, TakesOnTheCallersThread) {
  const auto caller = std::this_thread::get_id();
  dispatch(10, slowly,
           [&](std::size_t, const std::string&) { EXPECT_EQ(std::this_thread::get_id(), caller); },
           {3, 0});
}

TEST(Dispatch, AnErrorOfWorkComesAfterAllResultsBeforeIt) {
  Taken taken;
  const auto work = [](std::size_t index) {
    if (index == 100 || index == 120) throw std::runtime_error("item " + std::to_string(index));
    return slowly(index);
  };
  const std::string error = errorOf(work, std::ref(taken), 4);
  EXPECT_EQ(error, "item 100");
  expectTaken(taken, 0, 100);
}

TEST(Dispatch, AnErrorOfTakeEndsTheRun) {
  Taken taken;
  const auto take = [&](std::size_t index, const std::string& bytes) {
    if (index == 50) throw std::runtime_error("disk full");
    taken(index, bytes);
  };
  EXPECT_EQ(errorOf(slowly, take, 4), "disk full");
  expectTaken(taken, 0, 50);
}

}  // namespace
}  // namespace forge
