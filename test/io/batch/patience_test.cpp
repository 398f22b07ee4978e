#include "collision_forge/io/batch/patience.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace forge {
namespace {

TEST(Patience, DoesNothingWhenTheWaitEndsInTime) {
  { const Patience patience(0.05, "nobody"); }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

TEST(PatienceDeathTest, EndsTheProcessAndReportsWhatItAwaited) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto wait = [] {
    const Patience patience(0.05, "somebody");
    std::this_thread::sleep_for(std::chrono::seconds(60));
  };
  EXPECT_EXIT(wait(), testing::ExitedWithCode(EXIT_FAILURE),
              "process [0-9]+ has waited 0.05 s for somebody; the run ends");
}

}  // namespace
}  // namespace forge
