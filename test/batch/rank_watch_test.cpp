#include <gtest/gtest.h>
#include <signal.h>

#include <string>
#include <vector>

#include "collision_forge/batch/dispatch.h"
#include "collision_forge/batch/ranks.h"

// Over two ranks, one of which stops: that ends the run, so each is a run of mpirun of its own,
// which test/CMakeLists.txt reads the output of. One process alone does not stop, and has nobody to
// watch.
namespace forge {
namespace {

constexpr double kMaxSilence = 1.0;  // s

void stopIf(bool is_to_stop) {
  if (is_to_stop && Ranks::get().size() > 1) ::raise(SIGSTOP);
}

void dispatchWithOneThatStops(int stopping) {
  Ranks::get().watch(kMaxSilence);
  std::size_t count = 0;
  dispatch(
      8,
      [&](std::size_t) {
        stopIf(Ranks::get().rank() == stopping);
        return std::string();
      },
      [&](std::size_t, const std::string&) { ++count; }, {1, 0});
  EXPECT_EQ(count, 8u);
}

TEST(SilentRank, IsNamed) { dispatchWithOneThatStops(1); }

TEST(SilentRank, ThatDealsIsNamed) { dispatchWithOneThatStops(0); }

TEST(SilentRank, IsNamedWhereASumWaitsForIt) {
  Ranks::get().watch(kMaxSilence);
  stopIf(Ranks::get().rank() == 1);
  std::vector<double> numbers = {1.0};
  Ranks::get().sum(numbers);
  EXPECT_EQ(numbers[0], Ranks::get().size());
}

}  // namespace
}  // namespace forge
