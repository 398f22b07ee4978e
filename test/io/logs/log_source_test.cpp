#include "collision_forge/io/logs/log_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "collision_forge/io/logs/unknown_source.h"
#include "collision_forge/planner_test/settings/config.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const LogSource kEmbedded{COLLISION_FORGE_SOURCE_DIR "/data/embedded", ""};

TEST(LogSource, ARos2BagIsNamed) {
  const TemporaryFolder folder;
  folder.write("drive_0.db3", "");
  for (const std::string& path : {folder.path(), folder.path() + "/drive_0.db3"}) {
    EXPECT_THAT(errorOf([&] { versionOf({path, ""}); }), HasSubstr("is a ROS 2 bag"));
  }
}

TEST(LogSource, ASourceOfNoKindIsDescribed) {
  const TemporaryFolder folder;
  EXPECT_THAT(unknownSourceText(folder.path()), HasSubstr("scenario (.xml); the folder is empty"));
  EXPECT_THAT(unknownSourceText(folder.write("notes.txt", "x")), HasSubstr("file of another kind"));
  EXPECT_THAT(unknownSourceText(folder.write("none.txt", "")), HasSubstr("the file is empty"));
  folder.write("waymo/scene.pkl", "");
  EXPECT_THAT(unknownSourceText(folder.path() + "/waymo"), HasSubstr("begins with sd_"));
  folder.write("records/training.tfrecord-00000-of-01000", "");
  EXPECT_THAT(unknownSourceText(folder.path() + "/records"),
              HasSubstr("converters of ScenarioNet"));
}

TEST(LogSource, SeveralVersionsAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorOf([&] {
                versionOf({folder.path(), ""});
              }),
              HasSubstr("is neither a nuScenes root (no subfolder has scene.json), nor a folder of "
                        "ScenarioNet files"));
  folder.write("v1.0-mini/scene.json", "[]");
  EXPECT_EQ(versionOf({folder.path(), ""}), "v1.0-mini");
  folder.write("v1.0-trainval/scene.json", "[]");
  EXPECT_THAT(errorOf([&] {
                versionOf({folder.path(), ""});
              }),
              HasSubstr("v1.0-mini, v1.0-trainval"));
}

TEST(LogSource, WantedScenesAreInItsOrder) {
  EXPECT_THAT(wantedScenes(kEmbedded, {"scene-0003", "scene-0001"}),
              ElementsAre("scene-0001", "scene-0003"));
  EXPECT_EQ(wantedScenes(kEmbedded, {}), readSceneNames(kEmbedded));
  EXPECT_THROW(wantedScenes(kEmbedded, {"scene-9999"}), std::runtime_error);
}

Config config() { return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config"); }

/// Adds `us` to every timestamp of a table.
void shiftStamps(const std::string& path, std::int64_t us) {
  std::stringstream content;
  content << std::ifstream(path).rdbuf();
  const std::string text = content.str();
  const std::regex stamp("(\"timestamp\": *)([0-9]+)");
  std::ofstream file(path);
  std::size_t place = 0;
  for (std::sregex_iterator i(text.begin(), text.end(), stamp), end; i != end; ++i) {
    const auto at = static_cast<std::size_t>(i->position());
    file << text.substr(place, at - place) << (*i)[1] << std::stoll((*i)[2]) + us;
    place = at + static_cast<std::size_t>(i->length());
  }
  file << text.substr(place);
}

/// A scene of data/embedded with agents.
NuScenesRecording recorded() {
  return kEmbedded.format->open(kEmbedded, {{"scene-0001"}, config(), {}, {}})
      ->recording("scene-0001")
      .recording;
}

TEST(LogSource, StampsThatBeginAtZeroOrBeforeAreShifted) {
  const TemporaryFolder folder;
  std::filesystem::copy(kEmbedded.path, folder.path(), std::filesystem::copy_options::recursive);
  const NuScenesRecording before = recorded();
  const std::string shifted = folder.path() + "/v1.0-embedded/";
  for (const char* table : {"ego_pose", "sample", "sample_data"}) {
    shiftStamps(shifted + table + ".json", -before.ego_poses.front().timestamp_us);
  }
  const LogSource source{folder.path(), ""};
  std::vector<std::string> warnings;
  const OnWarnings keep = [&](const std::string&, const std::vector<std::string>& found) {
    warnings = found;
  };
  const NuScenesRecording after = source.format->open(source, {{"scene-0001"}, config(), keep, {}})
                                      ->recording("scene-0001")
                                      .recording;
  EXPECT_EQ(after.ego_poses.front().timestamp_us, 1000000);
  EXPECT_EQ(after.frames[1].timestamp_us - 1000000,
            before.frames[1].timestamp_us - before.ego_poses.front().timestamp_us);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("timestamps begin at 0 us: shifted")));
}

TEST(LogSource, RejectsARecordingWithTheEgoBeyondTheLimits) {
  NuScenesRecording recording = recorded();
  for (NuScenesEgoPose& pose : recording.ego_poses) pose.translation.y() -= 1.6e5;
  EXPECT_THAT(errorOf<InputError>([&] { keepWithin(recording, config(), nullptr); }),
              testing::AllOf(HasSubstr("scene-0001: ego: states[0].y"), HasSubstr("-100000")));
}

TEST(LogSource, RemovesInstancesBeyondTheLimits) {
  NuScenesRecording recording = recorded();
  const std::string id = recording.frames[0].annotations.at(0).instance;
  const auto countOf = [&](bool is_it) {
    std::ptrdiff_t count = 0;
    for (const NuScenesFrame& frame : recording.frames) {
      count += std::count_if(
          frame.annotations.begin(), frame.annotations.end(),
          [&](const auto& annotation) { return (annotation.instance == id) == is_it; });
    }
    return count;
  };
  const std::ptrdiff_t others = countOf(false);
  std::vector<std::string> warnings;
  keepWithin(recording, config(), &warnings);
  EXPECT_THAT(warnings, testing::IsEmpty());
  ASSERT_GT(countOf(true), 1);
  for (NuScenesFrame& frame : recording.frames) {
    for (NuScenesAnnotation& annotation : frame.annotations) {
      if (annotation.instance == id) annotation.size.x() = 100.0;
    }
  }
  keepWithin(recording, config(), &warnings);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("first: " + id)));
  EXPECT_EQ(countOf(true), 0);
  EXPECT_EQ(countOf(false), others);
}

}  // namespace
}  // namespace forge
