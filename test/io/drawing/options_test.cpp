#include "collision_forge/io/drawing/options.h"

#include <gtest/gtest.h>

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"

namespace forge {
namespace {

DrawingOptions shipped() {
  DrawingOptions options;
  readConfigFile(ConfigFolder(COLLISION_FORGE_SOURCE_DIR "/config"), "drawing", options);
  return options;
}

TEST(DrawingOptions, EgoIsBlueAttackerRedAndContactYellow) {
  const DrawingOptions options = shipped();
  EXPECT_GT(options.ego_color.blue, options.ego_color.red + 0.3);
  EXPECT_GT(options.attacker_color.red, options.attacker_color.blue + 0.3);
  EXPECT_GT(options.contact_color.red, options.contact_color.blue + 0.3);
  EXPECT_GT(options.contact_color.green, options.contact_color.blue + 0.3);
  EXPECT_GT(options.passed_color.green, options.passed_color.red + 0.2);
  EXPECT_GT(options.failed_color.red, options.failed_color.green + 0.2);
}

TEST(DrawingOptions, GifTimesAreWholeHundredthsOfASecond) {
  const double hundredths = 100.0 / shipped().gif_frames_per_second;
  EXPECT_EQ(hundredths, static_cast<int>(hundredths));
}

}  // namespace
}  // namespace forge
