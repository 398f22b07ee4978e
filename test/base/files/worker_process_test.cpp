#include "collision_forge/base/files/worker_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace forge {
namespace {

WorkerProcess shell(const std::string& script) { return WorkerProcess({"/bin/sh", "-c", script}); }

/// Returns the error message of receive().
template <typename Error>
std::string complaintOf(WorkerProcess& process) {
  char byte = 0;
  try {
    process.receive(&byte, 1);
    return "none";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(WorkerProcess, AnswersOverItsStream) {
  WorkerProcess process = shell("cat <&3 >&3");
  process.setTimeout(60.0);
  const std::string sent(1 << 12, 'x');
  std::string received(sent.size(), ' ');
  for (int i = 0; i < 3; ++i) {
    process.send(sent.data(), sent.size());
    process.receive(received.data(), received.size());
    EXPECT_EQ(received, sent);
  }
}

TEST(WorkerProcess, TimesOut) {
  WorkerProcess process = shell("exec sleep 60");
  process.setTimeout(0.1);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(complaintOf<WorkerTimeout>(process), testing::HasSubstr("0.1"));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(100));
}

TEST(WorkerProcess, ReportsHowItEnded) {
  for (const auto& [script, words] :
       {std::pair("exit 7", "exit code 7"), std::pair("kill -SEGV $$", "signal 11")}) {
    WorkerProcess process = shell(script);
    process.setTimeout(60.0);
    for (int again = 0; again < 2; ++again) {
      EXPECT_THAT(complaintOf<std::runtime_error>(process), testing::HasSubstr(words));
    }
  }
}

TEST(WorkerProcess, EndsWithItsObject) {
  pid_t pid = 0;
  {
    WorkerProcess process = shell("echo $$ >&3; exec sleep 60");
    process.setTimeout(60.0);
    char digit = 0;
    while (process.receive(&digit, 1), digit != '\n') pid = 10 * pid + digit - '0';
    EXPECT_EQ(kill(pid, 0), 0);
  }
  EXPECT_NE(kill(pid, 0), 0);
}

}  // namespace
}  // namespace forge
