#include "collision_forge/ros/bags/foxglove_layout.h"

#include <gtest/gtest.h>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

TEST(FoxgloveLayout, HasA3dViewAndASpeedPlot) {
  const JsonLine json("layout", foxgloveLayout());
  JsonObject root = json.root();
  JsonObject layout = root.object("layout");
  JsonObject panels = root.object("configById");
  JsonObject scene = panels.object(layout.text("first").c_str());
  JsonObject topics = scene.object("topics");
  for (const char* name : {names::kCrashMap, names::kCrashScene}) {
    EXPECT_TRUE(topics.object(bagTopic(name).c_str()).flag("visible")) << name;
  }
  EXPECT_EQ(scene.text("followTf"), names::kBaseFrame);
  JsonObject plot = panels.object(layout.text("second").c_str());
  std::vector<std::string> paths;
  for (JsonObject& path : plot.objects("paths", 100)) paths.push_back(path.text("value"));
  EXPECT_EQ(paths, (std::vector<std::string>{bagTopic(names::kEgoSpeed) + ".data",
                                             bagTopic(names::kAttackerSpeed) + ".data"}));
}

}  // namespace
}  // namespace forge
