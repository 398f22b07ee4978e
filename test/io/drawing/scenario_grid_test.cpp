#include "collision_forge/io/drawing/draw_grid.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>

#include "collision_forge/io/drawing/grid_painter.h"
#include "io/drawing/sample_view.h"

namespace forge {
namespace {

GridCell touching() { return {sampleView(), ""}; }

/// The attacker reverses, so there is no contact.
GridCell missing() {
  GridCell cell = touching();
  cell.view.report.contact = false;
  for (TrajectoryPoint& point : cell.view.trajectory.points) {
    point.pose.x = -14.9 - 2.0 * (point.time - cell.view.snapshot.now);
  }
  return cell;
}

GridCell refusing() {
  GridCell cell = touching();
  cell.refusal = "no answer: no attack within limits";
  cell.view.report = {};
  cell.view.trajectory.points.clear();
  return cell;
}

class DrawScenarioGrid : public testing::Test {
 protected:
  void TearDown() override { std::remove(path_.c_str()); }

  GridPainter painter(PictureKind kind = PictureKind::kStill) const {
    return {grid_, options_, 10.0, kind};
  }
  static std::uint32_t at(const Image& image, const GridPainter& painter, std::size_t row,
                          std::size_t column, const Vector2& world) {
    const Vector2 pixel = painter.viewport(row, column).toPixel(world);
    return image.pixel(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  }

  ScenarioGrid grid_{{"one", "two", "three"},
                     {{touching(), missing(), refusing()}, {touching(), touching(), touching()}}};
  DrawingOptions options_ = sampleOptions();
  std::string path_ = temporaryPath("grid");
};

TEST_F(DrawScenarioGrid, EveryCellIsItsScenarioAtItsContact) {
  const GridPainter grid = painter();
  const Image image = grid.paintContacts();
  for (const std::size_t row : {0, 1}) {
    EXPECT_EQ(at(image, grid, row, 0, {8, 0}), packedColor(options_.contact_color));
    EXPECT_EQ(at(image, grid, row, 0, {10.3, 0}), packedColor(options_.ego_color));
    EXPECT_EQ(at(image, grid, row, 0, {5, 0}), packedColor(options_.attacker_color));
  }
  // Without a contact, at the requested time: 2 s after t0.
  EXPECT_EQ(at(image, grid, 0, 1, {10, 0}), packedColor(options_.ego_color));
  EXPECT_NE(at(image, grid, 0, 1, {8, 0}), packedColor(options_.contact_color));
  EXPECT_EQ(at(image, grid, 0, 1, {-18.9, 0}), packedColor(options_.attacker_color));
}

TEST_F(DrawScenarioGrid, OutcomesAppearAtContactAndRejectionsAtOnce) {
  const GridPainter grid = painter(PictureKind::kAnimation);
  const Image before = grid.paint(2.0);
  const Image after = grid.paint(2.1);
  const auto hasText = [&](const Image& image, std::size_t column) {
    const PixelRect& cell = grid.viewport(0, column).area();
    for (int y = static_cast<int>(cell.y + cell.height) + 2; y < cell.y + cell.height + 17; ++y) {
      for (int x = static_cast<int>(cell.x); x < cell.x + cell.width; ++x) {
        if (image.pixel(x, y) != packedColor(options_.background_color)) return true;
      }
    }
    return false;
  };
  EXPECT_FALSE(hasText(before, 0)) << "contact after 2.04 s";
  EXPECT_TRUE(hasText(after, 0));
  EXPECT_TRUE(hasText(before, 1)) << "asked for after 2 s";
  EXPECT_TRUE(hasText(before, 2));
}

TEST_F(DrawScenarioGrid, CellsAreSynchronousAndHoldTheirLastFrame) {
  ScenarioView early = sampleView();
  early.report.contact_time = 101.0;
  early.report.ego_at_contact = {4.8, 0.0, 0.0};
  early.report.attacker_at_contact = {-4.9, 0.0, 0.0};
  for (AgentState& state : early.future.agents[1].states) {
    state.pose.x = -14.0 + 8.0 * (state.time - 100.0);  // the truck passes
  }
  grid_.rows = {{touching(), touching(), touching()}, {{early, ""}, {early, ""}, {early, ""}}};
  const GridPainter grid = painter(PictureKind::kAnimation);
  EXPECT_NEAR(grid.end(), 2.04 + early.seconds_after_stand, 1e-6);
  const Image now = grid.paint(0.0);
  EXPECT_EQ(at(now, grid, 0, 0, {-0.8, -0.6}), packedColor(options_.ego_color));
  const Image half = grid.paint(0.5);
  EXPECT_EQ(at(half, grid, 0, 1, {2.3, -0.6}), packedColor(options_.ego_color));
  EXPECT_EQ(at(half, grid, 1, 1, {2.3, -0.6}), packedColor(options_.ego_color));
  // The second row ends 1.5 s after t0, when the truck, 8 m long, is at -2 m.
  const Image last = grid.paint(grid.end());
  EXPECT_EQ(at(last, grid, 1, 2, {-2, 8}), packedColor(options_.agent_color));
  EXPECT_NE(at(last, grid, 1, 2, {5, 8}), packedColor(options_.agent_color));
}

TEST_F(DrawScenarioGrid, EndsWithTheKnownMotion) {
  grid_.rows.pop_back();
  for (GridCell& cell : grid_.rows[0]) cell.view.seconds_after_stand = 60.0;
  EXPECT_NEAR(painter().end(), 4.0, 1e-6) << "the ego's future";
  grid_.rows[0][1].view.trajectory.points.resize(31);
  EXPECT_NEAR(painter().end(), 3.0, 1e-6) << "an attacker that goes on";
}

TEST_F(DrawScenarioGrid, RejectsEmptyAndUnevenGrids) {
  EXPECT_THROW(drawScenarioGridPng(path_, {{"one"}, {}}, options_), std::invalid_argument);
  EXPECT_THROW(drawScenarioGridGif(path_, {{}, {{}}}, options_), std::invalid_argument);
  grid_.rows[1].pop_back();
  EXPECT_THROW(drawScenarioGridPng(path_, grid_, options_), std::invalid_argument);
  EXPECT_FALSE(exists(path_));
}

}  // namespace
}  // namespace forge
