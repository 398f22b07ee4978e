#include "collision_forge/io/batch/interruption.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace forge {
namespace {

class InterruptionNoticeDeathTest : public testing::TestWithParam<int> {
 protected:
  /// Raises the signal in a process of its own, which exits with 0 if the signal does not end it.
  [[noreturn]] static void raiseIn(void (*before)(int)) {
    ::signal(GetParam(), before);
    const InterruptionNotice notice("written up to here\n");
    ::raise(GetParam());
    std::exit(0);
  }
};

TEST_P(InterruptionNoticeDeathTest, PrintsTheMessageBeforeTheSignalEndsTheProcess) {
  EXPECT_EXIT(raiseIn(SIG_DFL), testing::KilledBySignal(GetParam()), "written up to here");
}

TEST_P(InterruptionNoticeDeathTest, AnIgnoredSignalStaysIgnored) {
  EXPECT_EXIT(raiseIn(SIG_IGN), testing::ExitedWithCode(0), "^$");
}

TEST_P(InterruptionNoticeDeathTest, RestoresTheEarlierHandlers) {
  EXPECT_EXIT(
      {
        ::signal(GetParam(), [](int /*signal*/) { ::_exit(7); });
        { const InterruptionNotice notice("written up to here\n"); }
        ::raise(GetParam());
      },
      testing::ExitedWithCode(7), "^$");
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptionNoticeDeathTest,
                         testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace forge
