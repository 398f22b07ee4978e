#include "collision_forge/io/batch/progress_line.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <iostream>
#include <sstream>

namespace forge {
namespace {

class ProgressLineTest : public testing::Test {
 protected:
  ProgressLine::Output output(bool is_terminal) {
    return {stream_, is_terminal, [this] { return time_; }};
  }
  /// Returns the output since the last call.
  std::string printed() {
    const std::string text = stream_.str();
    stream_.str("");
    return text;
  }

  std::ostringstream stream_;
  double time_ = 1000.0;  // s
};

TEST_F(ProgressLineTest, ShowsShareRateAndTimeLeft) {
  ProgressLine line("requests", 0.0, output(false));
  time_ += 20.0;
  line.show(50, 200);  // 2.5 a second, 150 to go
  EXPECT_EQ(printed(), "requests  25 %, 2.5/s, 60 s left\n");
}

TEST_F(ProgressLineTest, EarlierWorkCountsForTheShareOnly) {
  ProgressLine line("requests", 0.5, output(false));
  time_ += 20.0;
  line.show(124, 200);  // 24 in 20 s, 76 to go
  EXPECT_EQ(printed(), "requests  62 %, 1.2/s, 63 s left\n");
}

TEST_F(ProgressLineTest, InAPipeItPrintsALineEveryTenSecondsAndOneAtTheEnd) {
  ProgressLine line("scenes", 0.0, output(false));
  int lines = 0;
  for (int second = 1; second <= 35; ++second) {
    time_ += 1.0;
    line.show(static_cast<std::size_t>(second), 35);
    const std::string text = printed();
    if (text.empty()) continue;
    ++lines;
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_EQ(text.back(), '\n');
  }
  EXPECT_EQ(lines, 4);
}

TEST_F(ProgressLineTest, OnATerminalTheLineIsReplacedInPlaceAndEndsOnce) {
  ProgressLine line("scenes", 0.0, output(true));
  time_ += 1.0;
  line.show(1, 4);
  EXPECT_EQ(printed(), "\r\033[Kscenes  25 %, 1.0/s, 3 s left");
  time_ += 0.1;
  line.show(2, 4);
  EXPECT_EQ(printed(), "") << "too soon to be read";
  line.show(4, 4);
  EXPECT_EQ(printed().back(), '\n');
}

TEST_F(ProgressLineTest, WorkThatEndsEarlyEndsItsLine) {
  {
    ProgressLine line("scenes", 0.0, output(true));
    time_ += 1.0;
    line.show(1, 4);
    printed();
  }
  EXPECT_EQ(printed(), "\n");
  {
    ProgressLine line("scenes", 0.0, output(false));
    time_ += 20.0;
    line.show(1, 4);
    printed();
  }
  EXPECT_EQ(printed(), "");
}

/// Returns the output of `print` on a terminal that is both stdout and stderr.
std::string shownOnATerminal(const std::function<void()>& print) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  EXPECT_EQ(::grantpt(terminal), 0);
  EXPECT_EQ(::unlockpt(terminal), 0);
  const int screen = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
  std::fflush(nullptr);  // or the child would write buffered output, too
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(screen, STDOUT_FILENO);
    ::dup2(screen, STDERR_FILENO);
    print();
    std::cout.flush();
    ::_exit(0);
  }
  ::close(screen);
  std::string lines = "\n";
  char letter = 0;
  while (::read(terminal, &letter, 1) == 1) {
    lines += letter;
    const std::string kCleared = "\r\033[K";
    const std::size_t cleared = lines.find(kCleared);
    if (cleared == std::string::npos) continue;
    const std::size_t begin = lines.rfind('\n', cleared) + 1;
    lines.erase(begin, cleared + kCleared.size() - begin);
  }
  ::waitpid(child, nullptr, 0);
  ::close(terminal);
  return lines.substr(1);
}

TEST(PrintLine, ReplacesTheProgressLineOnATerminal) {
  const std::string shown = shownOnATerminal([] {
    double time = 0.0;
    ProgressLine progress("work", 0.0, {std::cerr, true, [&] { return time += 1.0; }});
    progress.show(0.5);
    printLine("warning: odd");
    progress.show(0.6);
    clearLine();
    std::cout << "a row" << std::endl;
    progress.show(1.0);
  });
  EXPECT_THAT(shown, testing::MatchesRegex("warning: odd\r\na row\r\nwork 100 %[^\n]*\r\n"));
}

}  // namespace
}  // namespace forge
