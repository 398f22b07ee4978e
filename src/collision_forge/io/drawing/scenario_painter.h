#pragma once

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/figure_layout.h"
#include "collision_forge/io/drawing/label_placer.h"
#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

/// Paints one scenario at any instant, turned by ScenePainter::rightwards(). The constructor paints
/// the static parts once. The view and the options must outlive it.
class ScenarioPainter {
 public:
  /// `size` is the largest size of the picture, which is less high where its map needs no more.
  ScenarioPainter(const ScenarioView& view, const DrawingOptions& options, const FigureSize& size,
                  PictureKind kind = PictureKind::kStill);

  /// Everybody at `time`; ghosts show where ego and attacker are from `ghosts_from` to contact.
  Image paint(double time, double ghosts_from) const;

  /// Pixels.
  int width() const { return background_.width(); }
  int height() const { return background_.height(); }

  /// Where the ground falls on the picture.
  const Viewport& mapViewport() const { return map_viewport_; }
  /// The square that shows the contact from near; after the contact it follows the vehicles.
  const Viewport& closeUpViewport() const { return close_up_viewport_; }

 private:
  struct Label {
    PixelRect place;
    Vector2 anchor;
    std::string text;
    Color color;
  };

  /// The viewport of the map in an area of this size, cropped above and below what is shown.
  Viewport fitMap(const PixelRect& area) const;
  void paintBackground();
  void placeLabels();
  Label makeLabel(Canvas& canvas, LabelPlacer& placer, const Vector2& world,
                  const std::string& text, const Color& color) const;
  void paintLabel(Canvas& canvas, const Label& label) const;

  const ScenarioView& view_;
  const DrawingOptions& options_;
  FigureSize size_;
  PictureKind kind_;
  ScenePainter scene_;
  Viewport map_viewport_;
  FigureLayout layout_;
  Viewport close_up_viewport_;
  Image background_;
  std::vector<Label> now_labels_;
  std::vector<Label> contact_labels_;  ///< one, or none without contact
};

}  // namespace forge
