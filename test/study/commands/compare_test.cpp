#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "collision_forge/app/command_line.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "io/collide/collide_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kSource = COLLISION_FORGE_SOURCE_DIR;

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The exit code and output of a command line.
struct Outcome {
  int exit_code = 0;
  std::string out;
  std::string err;
};

/// A folder of clips: rear-end crashes with a TTA of 2 s at 5 m/s and more, one crossing with 3 s.
class Compare : public testing::Test {
 protected:
  Compare() {
    for (int variant = 0; variant < 3; ++variant) {
      CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0 + variant,
                                      {-14.7, 0.0, 0.0}, 10.0 + variant);
      clip.variant = variant;
      write(clip);
    }
    write(
        straightClip(CollisionType::kJunctionCrossing, 90.0, 13, 5.0, {15.0, 20.0, -M_PI_2}, 6.0));
  }

  void write(const CollideClip& clip) {
    const std::string folder = folder_.path() + "/collide/trajectory/val";
    std::filesystem::create_directories(folder);
    names_.push_back(composeCollideName(clip));
    writeCollideClip(folder + "/" + names_.back(), clip);
  }

  /// Passes --config, because ROS may not find the package.
  Outcome run(const std::vector<std::string>& words, const std::string& out) const {
    std::vector<std::string> all = {"forge",
                                    "study",
                                    "compare",
                                    "--collide",
                                    folder_.path() + "/collide",
                                    "--dataroot",
                                    kSource + "/data/embedded",
                                    "--config",
                                    kSource + "/config",
                                    "--out",
                                    out};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<const char*> arguments;
    for (const std::string& word : all) arguments.push_back(word.c_str());
    CommandLine line;
    addStudyCommands(line);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const auto read = line.parse(static_cast<int>(arguments.size()), arguments.data());
    Outcome outcome;
    outcome.exit_code = read ? *read : line.run();
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    return outcome;
  }

  Outcome run(const std::vector<std::string>& words) const { return run(words, out()); }

  std::string out() const { return folder_.path() + "/figure"; }

  TemporaryFolder folder_;
  std::vector<std::string> names_;
};

TEST_F(Compare, WritesPngAndGifAndPrintsTheClips) {
  const Outcome outcome =
      run({"--methods", "recorded,constant_velocity,search", "--count", "2", "--seed", "3"});
  EXPECT_EQ(outcome.exit_code, kExitOk) << outcome.err;
  EXPECT_EQ(bytesOf(out() + ".png").substr(0, 4), "\x89PNG");
  EXPECT_EQ(bytesOf(out() + ".gif").substr(0, 4), "GIF8");
  EXPECT_FALSE(std::filesystem::exists(out() + ".gif.part"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("_RE_"), HasSubstr("_JC_"), HasSubstr(out() + ".png"),
                                 HasSubstr(out() + ".gif")));
}

TEST_F(Compare, DrawsNamedClipsInTheGivenOrder) {
  const Outcome outcome = run({"--methods", "recorded", "--clips", names_[3], names_[1]});
  EXPECT_EQ(outcome.exit_code, kExitOk) << outcome.err;
  const std::size_t crossing = outcome.out.find("_JC_");
  const std::size_t rear_end = outcome.out.find("_RE_");
  ASSERT_NE(crossing, std::string::npos);
  ASSERT_NE(rear_end, std::string::npos);
  EXPECT_LT(crossing, rear_end);
}

TEST_F(Compare, UnknownClipsAndMethodsAreUsageErrors) {
  const Outcome clip = run({"--methods", "recorded", "--clips", "scene-9999"});
  EXPECT_EQ(clip.exit_code, kExitUsage);
  EXPECT_THAT(clip.err, HasSubstr("--clips: \"scene-9999\" matches none of 4 clips in"));
  const Outcome method = run({"--methods", "recorded,magic"});
  EXPECT_EQ(method.exit_code, kExitUsage);
  EXPECT_THAT(method.err, HasSubstr("--methods: method \"magic\" is none of recorded, "));
  const Outcome count = run({"--methods", "recorded", "--count", "5"});
  EXPECT_EQ(count.exit_code, kExitUsage);
  EXPECT_THAT(count.err, HasSubstr("--count: only "));
  EXPECT_EQ(run({"--methods", "recorded", "--count", "0"}).exit_code, kExitUsage);
  EXPECT_EQ(run({"--methods", "recorded", "--count", "1", "--clips", names_[0]}).exit_code,
            kExitUsage);
  EXPECT_FALSE(std::filesystem::exists(out() + ".png"));
}

TEST_F(Compare, AMissingOutputFolderIsReportedBeforeMethodsRun) {
  const Outcome outcome =
      run({"--methods", "recorded", "--count", "1"}, folder_.path() + "/no/figure");
  EXPECT_EQ(outcome.exit_code, kExitError);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("/no does not exist"), Not(HasSubstr("attacks"))));
  const Outcome none = run({"--methods", "recorded", "--count", "1", "--split", "train"});
  EXPECT_EQ(none.exit_code, kExitError);
  EXPECT_THAT(none.err, HasSubstr("trajectory/train: no such folder"));
}

}  // namespace
}  // namespace forge
