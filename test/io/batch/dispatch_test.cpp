#include "collision_forge/io/batch/dispatch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// These tests run twice: in one process, and in three ranks of mpirun. In the second case every
// rank runs each test, and only the master takes results and gets errors.
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

/// Checks that exactly the items [first, end) were taken, in order, only on the master.
void expectTaken(const Taken& taken, std::size_t first, std::size_t end) {
  if (!isMaster()) {
    EXPECT_TRUE(taken.indices.empty());
    return;
  }
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
  EXPECT_EQ(count, isMaster() ? 20u : 0u);
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
  EXPECT_EQ(error, isMaster() ? "item 100" : "");
  expectTaken(taken, 0, 100);
}

TEST(Dispatch, AnErrorOfTakeEndsTheRun) {
  Taken taken;
  const auto take = [&](std::size_t index, const std::string& bytes) {
    if (index == 50) throw std::runtime_error("disk full");
    taken(index, bytes);
  };
  EXPECT_EQ(errorOf(slowly, take, 4), isMaster() ? "disk full" : "");
  expectTaken(taken, 0, 50);
}

TEST(Dispatch, EveryProcessDoesItsShare) {
  // The result of an item is the id of the process that worked on it; with mpirun, of each rank.
  const char* const size = std::getenv("OMPI_COMM_WORLD_SIZE");
  const std::size_t ranks = size ? std::stoul(size) : 1;
  std::map<std::string, std::size_t> items_of_process;
  dispatch(
      kCount,
      [](std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return std::to_string(::getpid());
      },
      [&](std::size_t, const std::string& bytes) { ++items_of_process[bytes]; }, {1, 0});
  if (!isMaster()) return;
  EXPECT_EQ(items_of_process.size(), ranks);
}

TEST(Dispatch, AnErrorInAnotherRankArrives) {
  const char* const rank = std::getenv("OMPI_COMM_WORLD_RANK");
  const bool is_alone = rank == nullptr;
  const bool is_other = !is_alone && std::string(rank) != "0";
  Taken taken;
  const auto work = [&](std::size_t index) {
    if (is_other) throw std::runtime_error("not here");
    return slowly(index);
  };
  const std::string error = errorOf(work, std::ref(taken), 1);
  EXPECT_EQ(error, is_alone || is_other ? "" : "not here");
  expectTaken(taken, 0, taken.indices.size());
}

}  // namespace
}  // namespace forge
