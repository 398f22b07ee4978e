#include "collision_forge/io/logs/nuscenes_sensors.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace forge {
namespace {

namespace fs = std::filesystem;

TEST(NuScenesSensors, ListsTheFilesOfTheEmbeddedScenes) {
  const std::string root = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
  const auto scenes = readNuScenesSensors(root, "v1.0-embedded", {"scene-0002"});
  ASSERT_EQ(scenes.size(), 1u);
  const NuScenesSensorScene& scene = scenes.at("scene-0002");
  ASSERT_EQ(scene.sensors.size(), 1u);
  EXPECT_EQ(scene.dataroot, root);
  EXPECT_EQ(scene.sensors[0].channel, "LIDAR_TOP");
  EXPECT_EQ(scene.sensors[0].modality, "lidar");
  EXPECT_EQ(scene.sensors[0].translation, Eigen::Vector3d(0.95, 0.0, 1.84));
  ASSERT_GT(scene.files.size(), 100u);
  for (std::size_t i = 1; i < scene.files.size(); ++i) {
    EXPECT_LT(scene.files[i - 1].timestamp_us, scene.files[i].timestamp_us);
  }
  EXPECT_EQ(scene.files[0].path.find(root + "/samples/LIDAR_TOP/scene-0002__"), 0u);
}

TEST(NuScenesSensors, ReadsCameraMatricesAndSizes) {
  const fs::path root = fs::temp_directory_path() / ("sensors_" + std::to_string(getpid()));
  fs::create_directories(root / "v");
  const auto write = [&](const char* table, const char* rows) {
    std::ofstream(root / "v" / (std::string(table) + ".json")) << rows;
  };
  write("scene", R"([{"token":"s","name":"one"}])");
  write("sample", R"([{"token":"a","scene_token":"s"}])");
  write("sensor", R"([{"token":"c","channel":"CAM_FRONT","modality":"camera"}])");
  write("calibrated_sensor",
        R"([{"token":"m","sensor_token":"c","translation":[1,2,3],"rotation":[1,0,0,0],
             "camera_intrinsic":[[10,0,5],[0,11,6],[0,0,1]]}])");
  write("sample_data",
        R"([{"token":"d","sample_token":"a","calibrated_sensor_token":"m","timestamp":7,
             "filename":"samples/x.jpg","width":1600,"height":900}])");
  const auto scenes = readNuScenesSensors(root.string(), "v", {});
  fs::remove_all(root);
  const NuScenesSensorScene& scene = scenes.at("one");
  EXPECT_EQ(scene.sensors[0].intrinsic,
            (std::array<double, 9>{10.0, 0.0, 5.0, 0.0, 11.0, 6.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(scene.files[0].width, 1600u);
  EXPECT_EQ(scene.files[0].path, (root / "samples/x.jpg").string());
}

}  // namespace
}  // namespace forge
