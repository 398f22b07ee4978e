#include <gtest/gtest.h>
#include <mpi.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/ranks.h"

// Two ranks, one of which stops. That ends the run, so each test is a run of mpirun of its own,
// whose output test/CMakeLists.txt checks. In a single process there is nothing to watch.
namespace forge {
namespace {

const RankOptions kImpatient = {1.0, 5.0};  // s

void stopIf(bool is_to_stop) {
  if (is_to_stop && Ranks::get().size() > 1) ::raise(SIGSTOP);
}

void dispatchWithOneThatStops(int stopping) {
  Ranks::watch(kImpatient);
  std::size_t count = 0;
  dispatch(
      8,
      [&](std::size_t) {
        stopIf(Ranks::get().rank() == stopping);
        // Keeps the other rank from doing all items before this one arrives.
        if (Ranks::get().size() > 1) std::this_thread::sleep_for(std::chrono::seconds(1));
        return std::string();
      },
      [&](std::size_t, const std::string&) { ++count; }, {1, 0});
  EXPECT_EQ(count, 8u);
}

TEST(SilentRank, IsNamed) { dispatchWithOneThatStops(1); }

TEST(SilentRank, ThatDealsIsNamed) { dispatchWithOneThatStops(0); }

TEST(SilentRank, ThatDoesNotComeIsNotWaitedFor) {
  const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
  if (rank != nullptr && std::string(rank) == "1") ::raise(SIGSTOP);
  Ranks::watch(kImpatient);
}

TEST(SilentRank, ThatDoesNotComeToTheEndIsNotWaitedFor) {
  Ranks::watch(kImpatient);
  if (Ranks::get().size() == 1) return;
  // MPI calls this when it is about to end.
  const auto stop = [](MPI_Comm, int, void*, void*) {
    stopIf(Ranks::get().rank() == 1);
    return MPI_SUCCESS;
  };
  int key = MPI_KEYVAL_INVALID;
  MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, stop, &key, nullptr);
  MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr);
  Ranks::get().settle();
}

TEST(SilentRank, IsNamedWhereASumWaitsForIt) {
  Ranks::watch(kImpatient);
  stopIf(Ranks::get().rank() == 1);
  std::vector<double> numbers = {1.0};
  Ranks::get().sum(numbers);
  EXPECT_EQ(numbers[0], Ranks::get().size());
}

}  // namespace
}  // namespace forge
