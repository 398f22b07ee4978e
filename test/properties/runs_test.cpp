// Runs that are interrupted and resumed, with any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "collision_forge/io/batch/run.h"
#include "io/logs/nuscenes_fixture.h"
#include "properties/random_scenes.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr int kJobs[] = {1, 2, 3, 5};
constexpr const char* kStop = "stopped by the test";

/// Cuts the file as a process that is killed while it writes.
void cutEnd(const std::string& path, Random& random) {
  const auto size = static_cast<std::size_t>(fs::file_size(path));
  fs::resize_file(path, size - random.index(std::min<std::size_t>(size, 40) + 1));
}

/// Starts a run that ends before an item, by an exception of the work or by a full disk.
void stopBefore(std::size_t item, Run run, Random& random) {
  const auto work = run.work;
  const auto take = run.take;
  if (isLikely(random, 0.5)) {
    run.work = [&](std::size_t index) {
      return index == item ? throw std::runtime_error(kStop) : work(index);
    };
  } else {
    run.take = [&](std::size_t index, const std::string& where, const std::string& lines) {
      if (index == item) throw std::runtime_error(kStop);
      take(index, where, lines);
    };
  }
  try {
    carryOut(run);
    FAIL() << "went on over " << item;
  } catch (const std::runtime_error& error) {
    ASSERT_STREQ(error.what(), kStop);
  }
}

Run runIn(const TemporaryFolder& folder, std::size_t count,
          const std::function<std::string(std::size_t)>& work) {
  Run run;
  run.path = folder.path() + "/lines";
  run.items = "items";
  run.count = count;
  run.work = work;
  run.take = [](std::size_t, const std::string&, const std::string&) {};
  return run;
}

/// Returns the output of a run that is stopped up to twice and resumed, each time with another
/// number of threads.
std::string carriedOut(std::size_t count, const std::function<std::string(std::size_t)>& work,
                       Random& random) {
  const TemporaryFolder folder;
  Run run = runIn(folder, count, work);
  testing::internal::CaptureStderr();
  std::size_t next = random.index(count);
  for (std::size_t stops = random.index(3); stops > 0 && next < count; --stops) {
    run.jobs = oneOf(kJobs, random);
    stopBefore(next, run, random);
    if (isLikely(random, 0.5)) cutEnd(run.path + ".part", random);
    if (isLikely(random, 0.2)) cutEnd(run.path + ".part.sums", random);
    next += 1 + random.index(count);
  }
  run.jobs = oneOf(kJobs, random);
  carryOut(run);
  testing::internal::GetCapturedStderr();
  return contentOf(run.path);
}

std::string inOrder(std::size_t count, const std::function<std::string(std::size_t)>& work) {
  std::string lines;
  for (std::size_t i = 0; i < count; ++i) lines += work(i) + "\n";
  return lines;
}

std::vector<std::string> anyLines(Random& random) {
  std::vector<std::string> lines(1 + random.index(40));
  for (std::string& line : lines) {
    line.assign(random.index(60), static_cast<char>('a' + random.index(26)));
  }
  return lines;
}

TEST(RunsProperties, LinesEqualAnUninterruptedRunOfOneThread) {
  forAllCases(
      [](Random& random) {
        const std::vector<std::string> lines = anyLines(random);
        const auto work = [&](std::size_t index) { return lines[index]; };
        EXPECT_EQ(carriedOut(lines.size(), work, random), inOrder(lines.size(), work));
      },
      0.5);
}

TEST(RunsProperties, AttacksEqualAnUninterruptedRunOfOneThread) {
  forAllCases(
      [](Random& random) {
        std::vector<SceneRequest> list(1 + random.index(6));
        for (SceneRequest& asked : list) {
          const AskedMoment moment = randomRequest(random, kAllModes);
          asked = {moment.recording->scene.name, moment.now, moment.request};
        }
        const auto work = [&](std::size_t index) { return scenarioLine(answered(list[index])); };
        EXPECT_EQ(carriedOut(list.size(), work, random), inOrder(list.size(), work));
      },
      0.05);
}

}  // namespace
}  // namespace forge
