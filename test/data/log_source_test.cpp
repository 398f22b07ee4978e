#include "collision_forge/data/log_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "data/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const LogSource kEmbedded{COLLISION_FORGE_SOURCE_DIR "/data/embedded", ""};

TEST(LogSource, TheOnlyVersionNeedsNoName) {
  EXPECT_EQ(versionOf(kEmbedded), "v1.0-embedded");
  EXPECT_EQ(versionOf({kEmbedded.path, "v2"}), "v2");
}

TEST(LogSource, SeveralVersionsAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorOf([&] { versionOf({folder.path(), ""}); }), HasSubstr("no folder in it"));
  folder.write("v1.0-mini/scene.json", "[]");
  EXPECT_EQ(versionOf({folder.path(), ""}), "v1.0-mini");
  folder.write("v1.0-trainval/scene.json", "[]");
  EXPECT_THAT(errorOf([&] {
                versionOf({folder.path(), ""});
              }),
              HasSubstr("v1.0-mini, v1.0-trainval"));
}

TEST(LogSource, ItsTitleIsShort) {
  EXPECT_EQ((LogSource{"/logs/nuscenes", "v1.0-mini"}.title()), "v1.0-mini");
  EXPECT_EQ((LogSource{"/logs/waymo/", ""}.title()), "waymo");
}

TEST(LogSource, WantedScenesAreInItsOrder) {
  EXPECT_THAT(wantedScenes(kEmbedded, {"scene-0003", "scene-0001"}),
              ElementsAre("scene-0001", "scene-0003"));
  EXPECT_EQ(wantedScenes(kEmbedded, {}), readSceneNames(kEmbedded));
  EXPECT_THROW(wantedScenes(kEmbedded, {"scene-9999"}), std::runtime_error);
}

}  // namespace
}  // namespace forge
