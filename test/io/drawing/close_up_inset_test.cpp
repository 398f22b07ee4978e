#include "collision_forge/io/drawing/close_up_inset.h"

#include <gtest/gtest.h>

#include "io/drawing/sample_view.h"

namespace forge {
namespace {

TEST(CloseUpInset, FollowsTheVehiclesAfterTheContact) {
  const ScenarioView view = sampleCrash();
  const DrawingOptions options = sampleOptions();
  const ScenePainter scene(view, options, 6.0, PictureKind::kAnimation, false);
  Image image(100, 100, options.text_color);
  Canvas canvas(image);
  CloseUpInset(scene, {20.0, 30.0, 64.0, 64.0}, options).paint(canvas, scene.motion().standTime());
  const double scale = 64.0 / options.close_up_extent;  // pixels a metre
  const int beside = 30 + 32 + static_cast<int>(0.6 * scale);
  EXPECT_EQ(image.pixel(20 + 32 + static_cast<int>(2.0 * scale), beside),
            packedColor(options.ego_color));
  EXPECT_EQ(image.pixel(20 + 32 - static_cast<int>(3.0 * scale), beside),
            packedColor(options.attacker_color));
}

TEST(CloseUpInset, ShowsTheContactOnlyInItsSquare) {
  const ScenarioView view = sampleView();
  const DrawingOptions options = sampleOptions();
  const ScenePainter scene(view, options, 6.0, PictureKind::kStill, false);
  Image image(100, 100, options.text_color);
  Canvas canvas(image);
  CloseUpInset(scene, {20.0, 30.0, 64.0, 64.0}, options).paint(canvas, view.report.contact_time);
  const double scale = 64.0 / options.close_up_extent;  // pixels a metre; the contact is at (8, 0)
  const int middle = 30 + 32;
  EXPECT_EQ(image.pixel(20 + 32, middle), packedColor(options.contact_color));
  EXPECT_EQ(image.pixel(20 + 32 + static_cast<int>(2.0 * scale), middle),
            packedColor(options.ego_color));
  EXPECT_EQ(image.pixel(20 + 32 - static_cast<int>(3.0 * scale), middle),
            packedColor(options.attacker_color));
  for (const int edge : {19, 84}) {
    EXPECT_EQ(image.pixel(edge, middle), packedColor(options.text_color));
  }
  EXPECT_EQ(image.pixel(50, 29), packedColor(options.text_color));
  EXPECT_EQ(image.pixel(50, 94), packedColor(options.text_color));
}

}  // namespace
}  // namespace forge
