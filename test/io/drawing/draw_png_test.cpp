#include <cairo.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "collision_forge/io/drawing/draw_scenario.h"
#include "collision_forge/io/drawing/scenario_painter.h"
#include "io/drawing/sample_view.h"

namespace forge {
namespace {

/// A PNG file read back.
class Picture {
 public:
  explicit Picture(const std::string& path)
      : surface_(cairo_image_surface_create_from_png(path.c_str()), &cairo_surface_destroy) {}

  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  std::uint32_t at(const Vector2& pixel) const {
    const auto* row = cairo_image_surface_get_data(surface_.get()) +
                      static_cast<int>(pixel.y()) * cairo_image_surface_get_stride(surface_.get());
    return reinterpret_cast<const std::uint32_t*>(row)[static_cast<int>(pixel.x())] & 0xFFFFFFU;
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
};

class DrawPng : public testing::Test {
 protected:
  void TearDown() override { std::remove(path_.c_str()); }

  /// Draws the view and returns the colours at points on the ground, in the map and in the
  /// close-up.
  void draw() { drawScenarioPng(path_, view_, options_); }
  std::uint32_t onMap(const Vector2& world) const {
    return Picture(path_).at(painter().mapViewport().toPixel(world));
  }
  std::uint32_t onCloseUp(const Vector2& world) const {
    return Picture(path_).at(painter().closeUpViewport().toPixel(world));
  }
  ScenarioPainter painter() const { return {view_, options_, pngSize(options_)}; }

  ScenarioView view_ = sampleView();
  DrawingOptions options_ = sampleOptions();
  std::string path_ = temporaryPath("scenario.png");
};

/// Returns the error message of drawing; "" if it succeeds.
template <typename Draw>
std::string errorOf(const Draw& draw) {
  try {
    draw();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(DrawPng, ARoadThatLeadsNorthLiesLevelWithNorthToTheRight) {
  const auto turn = [](Pose2& pose) { pose = {-pose.y, pose.x, pose.yaw + M_PI_2}; };
  const double level = painter().mapViewport().pixelsPerMetre();
  const int height = painter().height();
  for (Track* track : {&view_.snapshot.ego, &view_.future.ego, &view_.snapshot.agents[0]}) {
    for (AgentState& state : track->states) turn(state.pose);
  }
  for (TrajectoryPoint& point : view_.trajectory.points) turn(point.pose);
  turn(view_.pattern.ego.center);
  turn(view_.report.ego_at_contact);
  turn(view_.report.attacker_at_contact);
  const ScenarioPainter turned = painter();
  EXPECT_NEAR(turned.mapViewport().pixelsPerMetre(), level, 1e-9);
  EXPECT_EQ(turned.height(), height);
  const Vector2 middle = turned.mapViewport().area().center();
  const Vector2 north =
      turned.mapViewport().toWorld(middle + Vector2(10, 0)) - turned.mapViewport().toWorld(middle);
  EXPECT_NEAR(north.x(), 0.0, 1e-9);
  EXPECT_GT(north.y(), 0.0);
}

TEST_F(DrawPng, ShowsAllVehiclesAtContact) {
  options_.view_margin = 12.0;
  draw();
  EXPECT_EQ(onMap({10, 0}), packedColor(options_.ego_color));
  EXPECT_EQ(onMap({5.5, 0}), packedColor(options_.attacker_color));
  EXPECT_EQ(onMap({10, 8}), packedColor(options_.agent_color));
  EXPECT_EQ(onMap({30, 3.5}), packedColor(options_.drivable_color)) << "over the walkway";
  EXPECT_EQ(onMap({30, 5}), packedColor(options_.walkway_color));
  EXPECT_EQ(onMap({10, -8}), packedColor(options_.background_color));  // north is up
}

TEST_F(DrawPng, MarksTheContactOnMapAndCloseUp) {
  draw();
  EXPECT_EQ(onMap({8, 0}), packedColor(options_.contact_color));
  EXPECT_EQ(onCloseUp({8, 0}), packedColor(options_.contact_color));
  EXPECT_EQ(onCloseUp({10, -0.5}), packedColor(options_.ego_color));
  EXPECT_EQ(onCloseUp({5, 0}), packedColor(options_.attacker_color));
}

TEST_F(DrawPng, RejectsInvalidViewsAndKeepsTheOldFile) {
  draw();
  const std::string before = readBytes(path_);
  view_.trajectory.points.resize(5);
  EXPECT_NE(errorOf([this] { draw(); }).find(path_), std::string::npos);
  view_.trajectory.points.clear();
  const std::string message = errorOf([this] { draw(); });
  EXPECT_NE(message.find(path_), std::string::npos);
  EXPECT_NE(message.find("empty"), std::string::npos);
  view_ = sampleView();
  view_.report.contact_time = std::nan("");
  EXPECT_NE(errorOf([this] { draw(); }), "");
  EXPECT_EQ(readBytes(path_), before);
  EXPECT_FALSE(exists(path_ + ".part"));
}

}  // namespace
}  // namespace forge
